#include "rigsound/dsp/rate_converter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "dsp/rate_converter_rows.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/lanes.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;

namespace {

std::vector<float> sine(double hz, double rate, double seconds) {
  std::vector<float> x(static_cast<std::size_t>(std::lround(seconds * rate)));
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(std::sin(dsp::kTwoPi * hz / rate * static_cast<double>(i)));
  return x;
}

/// Of what comes out against the same sine made at the other rate, away from the ends, dB of the sine.
double error_db(double hz, int from, int to) {
  const std::vector<float> made = dsp::RateConverter(from, to).converted(sine(hz, from, 0.1)),
                           ideal = sine(hz, to, 0.1);
  REQUIRE(made.size() == ideal.size());
  double error = 0, energy = 0;
  for (std::size_t i = made.size() / 4; i < made.size() * 3 / 4; ++i) {
    error += std::pow(static_cast<double>(made[i]) - static_cast<double>(ideal[i]), 2);
    energy += std::pow(static_cast<double>(ideal[i]), 2);
  }
  return 10 * std::log10(error / energy);
}

}  // namespace

TEST_CASE("a sine at another rate is that sine") {
  for (const double hz : {100.0, 1000.0, 8000.0, 15000.0, 18000.0}) {
    CHECK_MESSAGE(error_db(hz, 44100, 48000) < -80, hz);
    CHECK_MESSAGE(error_db(hz, 96000, 48000) < -80, hz);
    CHECK_MESSAGE(error_db(hz, 48000, 44100) < -80, hz);
    CHECK_MESSAGE(error_db(hz, 48000, 47999) < -80, hz);  // more phases than rows
  }
}

TEST_CASE("what the lower rate cannot carry is gone") {
  const std::vector<float> made = dsp::RateConverter(96000, 48000).converted(sine(27000, 96000, 0.1));
  double peak = 0;
  for (std::size_t i = made.size() / 4; i < made.size() * 3 / 4; ++i)
    peak = std::max(peak, std::fabs(static_cast<double>(made[i])));
  CHECK(peak < 1e-4);
}

TEST_CASE("eight floats side by side give the bits of four") {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) return;
  constexpr std::size_t kTaps = 48, kUp = 160, kCount = 2000;
  const dsp::RandomField random(5, 0, 0);
  std::vector<float> weights(kUp * kTaps), x(kCount + kTaps), four(kCount), eight(kCount);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<float>(random.normal(i, 0));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<float>(random.normal(i, 1));
  const dsp::PhaseRows rows{weights.data(), kUp, 147, kTaps};
  dsp::convert_rows<dsp::dot>(rows, x.data(), four.data(), kCount);
  dsp::convert_rows_eight(rows, x.data(), eight.data(), kCount);
  CHECK(four == eight);
#endif
}

TEST_CASE("sample 0 stays sample 0, and the sound lasts as long") {
  const std::vector<float> impulse{1, 0, 0, 0, 0};
  const std::vector<float> made = dsp::RateConverter(8000, 192000).converted(impulse);
  CHECK(made.size() == 120);
  CHECK(std::max_element(made.begin(), made.end()) == made.begin());
  CHECK(dsp::RateConverter(44100, 48000).converted({}).empty());
  CHECK(dsp::RateConverter(48000, 44100).converted({1}).size() == 1);
}
