#include "background/background_layer.hpp"
#include "rigsound/analysis/background.hpp"
#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

std::vector<float> play_background(const BackgroundModel& model, const std::vector<double>& rpm, double load,
                                   double feed, unsigned seed) {
  constexpr double kSettle_s = 1.5;     // the engine spins up before the first sample
  constexpr double kAlwaysRunning = 2;  // r/min of idle: the engine never counts as stopping
  background::BackgroundLayer layer({model}, kAnalysisRate, seed, kAlwaysRunning);
  double chunk[kChunk];
  for (int n = 0; n < static_cast<int>(kSettle_s * kAnalysisRate); n += kChunk)
    layer.process({rpm.front(), load, feed}, chunk);
  std::vector<float> out;
  out.reserve(rpm.size() + kChunk);
  for (std::size_t n = 0; n < rpm.size(); n += kChunk) {
    layer.process({rpm[n], load, feed}, chunk);
    for (const double v : chunk) out.push_back(static_cast<float>(v));
  }
  out.resize(rpm.size());
  return out;
}

}  // namespace rigsound::analysis
