#include "note/harmonic_error.hpp"

#include <array>
#include <cmath>

#include "diesel/order_spectrum.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kPeriods = 16;

}  // namespace

HarmonicError harmonic_error(const std::vector<double>& a, const std::vector<double>& b, int P, int highest) {
  const std::vector<double> pa = order_spectrum(a, P, kPeriods), pb = order_spectrum(b, P, kPeriods);
  std::array<double, 3> squares{};
  for (int k = 1; k <= highest; ++k) {
    std::array<double, 3> ea{}, eb{};
    for (int step = -kPeriods / 2; step < kPeriods / 2; ++step) {
      const int distance = std::abs(step);  // in sixteenths of f0
      const std::size_t band = distance <= kPeriods / 8 ? 0 : distance <= kPeriods / 4 ? 1 : 2;
      const auto bin = static_cast<std::size_t>(k * kPeriods + step);
      ea[band] += pa[bin], eb[band] += pb[bin];
    }
    for (std::size_t band = 0; band < 3; ++band)
      squares[band] += std::pow(10 * std::log10((ea[band] + 1e-30) / (eb[band] + 1e-30)), 2) / highest;
  }
  return {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2])};
}

SubbandEnergies subband_energies(const std::vector<double>& y, int P) {
  const std::vector<double> power = order_spectrum(y, P, kPeriods);
  SubbandEnergies energies;
  for (int q = 0; q < P; ++q) {
    const int harmonic = (q + 1) / 2 * kPeriods, side = q % 2 == 0 ? 1 : -1;
    const auto sum = [&](int nearest, int farthest) {
      double energy = 1e-30;
      for (int d = nearest; d <= farthest; ++d)
        energy += power[static_cast<std::size_t>(harmonic + side * d)];
      return energy;
    };
    energies[0].push_back(sum(kPeriods / 4 + 1, kPeriods / 2));
    energies[1].push_back(sum(kPeriods / 8 + 1, kPeriods / 4));
    energies[2].push_back(sum(kPeriods / 8, kPeriods / 8));
  }
  return energies;
}

}  // namespace rigsound::analysis
