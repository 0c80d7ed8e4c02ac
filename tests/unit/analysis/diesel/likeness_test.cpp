// Fractional octaves, valleys and standing orders of sounds whose spectra are known.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/noise.hpp"
#include "diesel/likeness.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kSamples = 1024, kCycles = 160;
constexpr double kCycle_hz = 8;

/// White noise of power 1, and a line of amplitude `line` on order 60 (480 Hz).
CyclicSound line_in_noise(double line, unsigned seed) {
  TestNoise noise(seed);
  CyclicSound s{{}, kSamples, kCycle_hz};
  for (int n = 0; n < kSamples * kCycles; ++n)
    s.y.push_back(noise.normal() + line * std::cos(2 * M_PI * 60 * n / kSamples));
  return s;
}

}  // namespace

TEST_CASE("bands of a fraction of an octave of white noise rise with their width, and share its power") {
  const std::vector<double> thirds = fractional_octaves(line_in_noise(0, 1), 3, 250, 1100);
  const double width = std::exp2(1.0 / 6) - std::exp2(-1.0 / 6), nyquist = kSamples * kCycle_hz / 2;
  for (std::size_t b = 0; b < thirds.size(); ++b)
    CHECK(thirds[b] ==
          doctest::Approx(10 * std::log10(250 * std::exp2(double(b) / 3) * width / nyquist)).epsilon(0.05));
  CHECK(fractional_octaves(line_in_noise(0, 1), 24, 250, 999).size() == 48);
}

TEST_CASE("a valley is as deep as the lowest band of its group lies under the highest") {
  CHECK(valley_depth({-10, -14, -11, -20, -20, -20, -90}, 3) == doctest::Approx(2));
}

TEST_CASE("an order that stands out of the noise counts, and how much lower it stands elsewhere") {
  const CyclicSound loud = line_in_noise(0.5, 2), soft = line_in_noise(0.5 / 2, 3);
  const StandingOrders orders = standing_orders(soft, loud, 300, 1000);
  CHECK(orders.count == 1);
  CHECK(orders.lost_db == doctest::Approx(6).epsilon(0.25));
  CHECK(standing_orders(soft, line_in_noise(0, 4), 300, 1000).count == 0);
}
