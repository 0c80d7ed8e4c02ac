#include "rigsound/analysis/diesel_spectrum.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "diesel/compared_cycles.hpp"
#include "diesel/cyclic_spectrum.hpp"
#include "diesel/order_analysis.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kHeardCycles = 48;  // eleven windows of the bands: scatter of 1.3 dB

DieselSpectrum spectrum_of(const Section& section, int N) {
  const double f0 = section.f0();
  CycleBlock block = cycles_of(section, section.x, 0, N);
  const int last = static_cast<int>(std::ceil(kHighestShownOrder_hz / f0));
  const Curve orders = order_levels(orders_of(block, 0, block.cycles, last).C, f0);
  return {rpm_of_cycles(f0), band_levels({std::move(block.y), N, f0}), orders};
}

}  // namespace

DieselSpectrum modelled_spectrum(const DieselModel& model, double rpm, double load) {
  return spectrum_of(played_section(model, rpm, load, kHeardCycles, 1), model.angle_samples);
}

DieselSpectrum recorded_spectrum(const DieselTake& take, int angle_samples) {
  std::vector<std::string> ignored;
  return spectrum_of(sections_of({take}, ignored).front(), angle_samples);
}

}  // namespace rigsound::analysis
