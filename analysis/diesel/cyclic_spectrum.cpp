#include "diesel/cyclic_spectrum.hpp"

#include <cmath>

#include "diesel/order_spectrum.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kBandCycles = 8;
constexpr double kNoLevel = 1e-20;

}  // namespace

Curve band_levels(const CyclicSound& s) {
  const std::vector<double> power = order_spectrum(s.y, s.N, kBandCycles);
  Curve curve;
  for (std::size_t b = 1; b < power.size(); ++b) {
    const double f = static_cast<double>(b) / kBandCycles * s.f0;
    if (f < kLowestShown_hz || f > kHighestShown_hz) continue;
    curve.x.push_back(f), curve.y.push_back(10 * std::log10(power[b] + kNoLevel));
  }
  return curve;
}

Curve order_levels(const std::vector<std::complex<double>>& C, double f0) {
  Curve curve;
  for (std::size_t k = 1; k <= C.size() && static_cast<double>(k) * f0 < kHighestShownOrder_hz; ++k) {
    curve.x.push_back(static_cast<double>(k) * f0);
    curve.y.push_back(10 * std::log10(0.5 * std::norm(C[k - 1]) + kNoLevel));
  }
  return curve;
}

}  // namespace rigsound::analysis
