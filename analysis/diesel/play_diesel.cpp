#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/diesel_player.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::analysis {

std::vector<float> play_diesel(const DieselModel& model, const std::vector<double>& rpm, double load,
                               double feed, unsigned seed, const Progress& progress) {
  constexpr double kSettle_s = 1.5;  // the engine spins up before the first sample
  DieselPlayer player(model, kAnalysisRate, seed);
  double chunk[kChunk];
  for (int n = 0; n < static_cast<int>(kSettle_s * kAnalysisRate); n += kChunk)
    player.process({rpm.front(), load, feed}, chunk);
  std::vector<float> out;
  out.reserve(rpm.size() + kChunk);
  for (std::size_t n = 0; n < rpm.size(); n += kChunk) {
    player.process({rpm[n], load, feed}, chunk);
    show(progress, n, rpm.size());
    for (const double v : chunk) out.push_back(static_cast<float>(v));
  }
  out.resize(rpm.size());
  return out;
}

}  // namespace rigsound::analysis
