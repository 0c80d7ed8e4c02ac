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

namespace {

/// Of 60 strikes whose ln beta is `level` of the step plus scatter.
template <class Level>
double strengths(Level level, double scatter, unsigned seed) {
  TestNoise noise(seed);
  std::vector<long> onset;
  std::vector<double> beta;
  for (int step = 0; step < 60; ++step) {
    onset.push_back(1000L * step);
    beta.push_back(std::exp(level(step) + scatter * noise.normal()));
  }
  return strength_rhythm(beta, onset);
}

}  // namespace

TEST_CASE("cylinders that differ by as much as they scatter are a rhythm of strengths") {
  const auto four = [](int step) { return (step % 4 < 2 ? 0.2 : -0.2) + (step % 4 == 3 ? 0.1 : 0); };
  CHECK(strengths(four, 0.2, 1) > 6);
}

TEST_CASE("random strengths and alternating double impacts are none") {
  double highest = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
    highest = std::max(highest, strengths([](int) { return 0.0; }, 0.3, seed));
  CHECK(highest < 5);
  CHECK(strengths([](int step) { return 0.01 * (step % 3); }, 0.001, 3) < 1);  // equal clicks, fitted
  CHECK(strengths([](int step) { return step % 2 == 0 ? 0.5 : -0.5; }, 0.2, 2) < 3);
}

TEST_CASE("the significance is that of an F test") {
  // Three places of means -1, 0, 1, each with -1, 0, 1 about its mean: F(2, 6) = (6 / 2) / (6 / 6) = 3.
  const std::vector<double> ln_beta = {-2, -1, 0, -1, 0, 1, 0, 1, 2};
  std::vector<long> onset;
  std::vector<double> beta;
  for (std::size_t step = 0; step < ln_beta.size(); ++step) {
    onset.push_back(long(step));
    beta.push_back(std::exp(ln_beta[step]));
  }
  CHECK(strength_rhythm(beta, onset) == doctest::Approx(-std::log10(0.125)).epsilon(0.05));
}
