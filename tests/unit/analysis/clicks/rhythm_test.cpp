// Rhythm of clicks, against patterns that are there and patterns that are not.
#include "clicks/rhythm.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace {

/// Clicks at steps 0, 1, ... of 20 frames, without the steps in `missed`; level(step, band) in nepers.
template <class Level>
double rhythm_of(int steps, const std::vector<int>& missed, Level level) {
  std::vector<long> onset;
  std::vector<int> present;
  for (int step = 0; step < steps; ++step) {
    if (std::find(missed.begin(), missed.end(), step) != missed.end()) continue;
    onset.push_back(20L * step);
    present.push_back(step);
  }
  Eigen::ArrayXXd levels(19, present.size());
  for (long i = 0; i < levels.cols(); ++i)
    for (long band = 0; band < 19; ++band) levels(band, i) = level(present[size_t(i)], int(band));
  return rhythm(levels, onset);
}

}  // namespace

TEST_CASE("bars of 3 to 12 steps explain all of a pattern, misses or not") {
  for (int bar = 3; bar <= 12; ++bar) {
    CAPTURE(bar);
    const auto pattern = [&](int step, int band) { return std::sin(1.7 * (step % bar) + band); };
    CHECK(rhythm_of(48, {}, pattern) == doctest::Approx(1));
    CHECK(rhythm_of(48, {5, 17, 18, 30}, pattern) == doctest::Approx(1));
  }
}

TEST_CASE("a pattern in as much noise explains half") {
  TestNoise noise(7);
  const auto level = [&](int step, int) {
    return (step % 4 == 0 ? std::sqrt(3.0) : -1 / std::sqrt(3.0)) + noise.normal();
  };
  CHECK(rhythm_of(400, {}, level) == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("strikes that differ at random have no rhythm, and too few cannot show one") {
  TestNoise noise(8);
  const auto level = [&](int, int) { return noise.normal(); };
  CHECK(rhythm_of(40, {}, level) < 0.1);
  CHECK(rhythm_of(7, {}, [](int step, int) { return double(step % 3); }) == 0);
}
