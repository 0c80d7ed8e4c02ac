// The period is that of the impacts, not half or twice of it, from 3 to 120 Hz.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/noise.hpp"
#include "clicks/selection.hpp"

using namespace rigsound::analysis;

namespace {

constexpr long kLength = 96000;

/// White noise whose power jumps at every impact and decays: what a whitened drill looks like.
Eigen::ArrayXd drill(double rate_hz, TestNoise& noise) {
  const double T = 48000 / rate_hz, decay = std::pow(10, -(1.2 + 2.4 * noise.uniform()) / T),
               snr = std::pow(10, 1.2 * noise.uniform());
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(kLength);
  for (double t = 0.7 * T * noise.uniform(); t < kLength; t += T * std::max(0.4, 1 + 0.05 * noise.normal()))
    if (noise.uniform() > 0.03)
      power(static_cast<long>(t)) += std::pow(std::max(0.3, 1 + 0.2 * noise.normal()), 2);
  for (long n = 1; n < kLength; ++n) power(n) += decay * power(n - 1);
  power = 1 + power * (snr / power.mean());
  return noise.normals(kLength) * power.sqrt();
}

}  // namespace

TEST_CASE("of 200 drills of 3 to 120 Hz, at 0 to 12 dB, at most two are an octave off") {
  int wrong = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    TestNoise noise(seed);
    const double rate_hz = 3 * std::pow(40, noise.uniform());
    Eigen::ArrayXd y = drill(rate_hz, noise);
    y /= std::sqrt(y.square().mean());
    const double found_hz = 3000 / select_clicks(find_candidates(y), kDrillingRates).mean_gap_blocks;
    if (std::fabs(std::log(found_hz / rate_hz)) < 0.1) continue;
    ++wrong;
    MESSAGE("seed ", seed, ": ", rate_hz, " Hz taken for ", found_hz);
  }
  CHECK(wrong <= 2);
}
