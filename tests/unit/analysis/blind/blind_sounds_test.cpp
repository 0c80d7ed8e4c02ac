// Sounds of a blind listening test: the mask of BS.1534's low anchor, and loudness as ISO 532-1 counts it.
#include "rigsound/analysis/blind_sounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/noise.hpp"
#include "contrast/loudness.hpp"
#include "rigsound/analysis/rate.hpp"

using namespace rigsound::analysis;

namespace {

std::vector<float> sine(double hz, double amplitude) {
  std::vector<float> x;
  for (int n = 0; n < 2 * kAnalysisRate; ++n)
    x.push_back(static_cast<float>(amplitude * std::sin(2 * kPi * hz * n / kAnalysisRate)));
  return x;
}

/// Of the middle half: where a sine begins and ends it has every frequency.
double level_db(const std::vector<float>& x) {
  double power = 0;
  for (std::size_t n = x.size() / 4; n < 3 * x.size() / 4; ++n) power += x[n] * x[n];
  return 10 * std::log10(power / (static_cast<double>(x.size()) / 2) + 1e-30);
}

std::vector<float> noise() { return samples(0.1 * TestNoise(5).normals(96000)); }

double anchor_db(double hz) {
  const std::vector<float> x = sine(hz, 0.5);
  return level_db(low_anchor(x)) - level_db(x);
}

double sone(std::vector<float> x, double gain_db) {
  for (float& value : x) value *= static_cast<float>(std::pow(10, gain_db / 20));
  return loudness_sone(loudness_bands(x, 100));
}

}  // namespace

TEST_CASE("the anchor lies within the mask of BS.1534") {
  for (const double hz : {50.0, 440.0, 1000.0, 2000.0, 3000.0, 3400.0, 3500.0})
    CHECK_MESSAGE(std::fabs(anchor_db(hz)) <= 0.1, hz);
  CHECK(anchor_db(4000) <= -25);
  for (const double hz : {4500.0, 5000.0, 8000.0, 15000.0, 23000.0}) CHECK_MESSAGE(anchor_db(hz) <= -50, hz);
}

TEST_CASE("the anchor has no delay and the length of what it is made from") {
  std::vector<float> x(9999);
  x[5000] = 1;
  const std::vector<float> y = low_anchor(x);
  REQUIRE(y.size() == x.size());
  CHECK(std::max_element(y.begin(), y.end()) - y.begin() == 5000);
  for (std::size_t n = 1; n < 4999; ++n) CHECK(y[5000 - n] == doctest::Approx(y[5000 + n]).epsilon(1e-5));
}

TEST_CASE("an excerpt has the length asked for, its sound in place and faded ends") {
  const std::vector<float> x(48000, 1.0F);
  const std::vector<float> y = excerpt(x, 24000, 12000), behind = excerpt(x, 47000, 12000);
  REQUIRE(y.size() == 12000);
  CHECK(y.front() == 0);
  CHECK(y.back() == 0);
  CHECK(y[120] == doctest::Approx(0.5));
  CHECK(y[240] == 1);
  CHECK(behind[999] == 1);
  CHECK(behind[1000] == 0);
  CHECK(excerpt(x, 50000, 10) == std::vector<float>(10));
}

TEST_CASE("matched sounds are equally loud, and none is clipped") {
  const std::vector<std::vector<float>> sounds = {sine(1000, 0.1), sine(1000, 0.05), sine(250, 0.1),
                                                  low_anchor(noise()), noise()};
  const std::vector<double> gains = matching_gains_db(sounds);
  REQUIRE(gains.size() == sounds.size());
  CHECK(gains[1] - gains[0] == doctest::Approx(20 * std::log10(2)).epsilon(1e-3));
  const double wanted = loudness_level_phon(sone(sounds[0], 0));
  float highest = 0;
  for (std::size_t i = 0; i < sounds.size(); ++i) {
    CHECK(loudness_level_phon(sone(sounds[i], gains[i] - gains[0])) == doctest::Approx(wanted).epsilon(2e-4));
    for (const float value : sounds[i])
      highest = std::max(highest, std::fabs(value) * static_cast<float>(std::pow(10, gains[i] / 20)));
  }
  CHECK(20 * std::log10(highest) <= -1 + 1e-3);
}

TEST_CASE("of matched sounds the highest peak is at -1 dBFS when it would be over it") {
  const std::vector<double> gains = matching_gains_db({sine(1000, 1), sine(1000, 0.5)});
  CHECK(gains[0] == doctest::Approx(-1).epsilon(0.01));
  CHECK(gains[1] == doctest::Approx(-1 + 20 * std::log10(2)).epsilon(0.01));
}

TEST_CASE("silence is left as it is") {
  const std::vector<double> gains = matching_gains_db({sine(1000, 0.1), std::vector<float>(96000)});
  CHECK(gains == std::vector<double>{0, 0});
}
