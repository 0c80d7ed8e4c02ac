#include "diesel/compared_cycles.hpp"

#include <algorithm>

#include "diesel/order_analysis.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kTurningOrders = 300;  // more than enough to tell the crank angle

CyclicSound turned(const Section& section, const DieselPoint& point, int N) {
  Orders known;
  for (const std::complex<float> c : point.orders) known.C.emplace_back(c);
  known.noise.assign(known.C.size(), 0.0);
  const CycleBlock raw = cycles_of(section, section.x, 0, N);
  const int last = static_cast<int>(std::min(known.C.size(), kTurningOrders));
  const double shift = crank_shift(known, orders_of(raw, 0, raw.cycles, last));
  return {cycles_of(section, section.x, shift, N).y, N, section.f0()};
}

}  // namespace

CyclicSound recorded_cycles(const Section& section, const DieselPoint& point, int N) {
  return turned(section, point, N);
}

Section played_section(const DieselModel& model, double rpm, double load, int cycles, unsigned seed) {
  const double f0 = cycles_per_second(rpm);
  const auto samples = static_cast<std::size_t>((cycles + 2) / f0 * kAnalysisRate);
  const std::vector<float> y = play_diesel(model, std::vector<double>(samples, rpm), load, 0, seed);
  Section section;
  section.x.assign(y.begin(), y.end());
  for (std::size_t n = 0; n < y.size(); ++n)
    section.theta.push_back(f0 * static_cast<double>(n) / kAnalysisRate);
  return section;
}

CyclicSound played_cycles(const DieselModel& model, const DieselPoint& point, int cycles, unsigned seed) {
  return turned(played_section(model, point.rpm, point.load, cycles, seed), point, model.angle_samples);
}

}  // namespace rigsound::analysis
