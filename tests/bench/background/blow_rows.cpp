// A background learned from a recording with a hammer in it.
#include <cmath>
#include <vector>

#include "background/learning.hpp"
#include "background/table.hpp"
#include "diesel/compared_cycles.hpp"
#include "rigsound/analysis/rate.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::bench {
namespace {

using namespace rigsound::analysis;

constexpr double kSpeed_rpm = 1200, kSeconds = 30, kBlowRate_hz = 35, kDecay_s = 0.006;

double rms(const std::vector<float>& x) {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v) * static_cast<double>(v);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

/// Adds white bursts that die away with kDecay_s, `db` over the engine.
DieselTake hammered(DieselTake take, double db) {
  SplitMix draw(9);
  std::vector<float> blows(take.mono.size(), 0.0F);
  for (double t = 0.01; t < kSeconds - 0.1; t += (1 + 0.03 * draw.normal()) / kBlowRate_hz) {
    take.impacts_s.push_back(t);
    const auto start = static_cast<std::size_t>(std::ceil(t * kAnalysisRate));
    for (std::size_t n = start; n < blows.size() && n < start + 4800; ++n)
      blows[n] += static_cast<float>(draw.normal() *
                                     std::exp(-(static_cast<double>(n) / kAnalysisRate - t) / kDecay_s));
  }
  const double gain = std::pow(10, db / 20) * rms(take.mono) / rms(blows);
  for (std::size_t n = 0; n < blows.size(); ++n) take.mono[n] += static_cast<float>(gain) * blows[n];
  return take;
}

double learned_error(const DieselTake& clean, const DieselTake& heard) {
  DieselSettings settings;
  settings.name = "hammered";
  const DieselModel model = learn_diesel({heard}, settings).model;
  const DieselPoint& point = model.points.front();
  return likeness(played_cycles(model, point, 200, 1),
                  recorded_cycles(section_of(clean), point, model.angle_samples), 9000)
      .third_octave_db;
}

}  // namespace

void blow_rows(Table& table) {
  const DieselTake clean = steady_take(kSpeed_rpm, kSeconds, 1);
  table.at_most("learned under blows as loud as the engine", 3.0, learned_error(clean, hammered(clean, 0)),
                "dB");
  table.at_most("learned under blows 6 dB louder", 5.5, learned_error(clean, hammered(clean, 6)), "dB");
  DieselTake deaf = hammered(clean, 0);
  deaf.impacts_s.clear();
  table.note("  the blows listened to, equal level", learned_error(clean, deaf), "dB");
}

}  // namespace rigsound::bench
