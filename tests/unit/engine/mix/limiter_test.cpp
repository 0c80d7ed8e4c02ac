// The limiters' ways down and back, against their time constants.
#include "mix/limiter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mix/lookahead_limiter.hpp"

using namespace rigsound;
using namespace rigsound::mix;

namespace {

constexpr double kCeiling = 0.5, kRecovery_s = 0.12, kHold_s = 0.010;

/// One chunk of 0.1 on both channels, but for a sample of `peak` at `at` on `channel`.
std::vector<dsp::Lanes> chunk_of(double peak, int at, int channel) {
  std::vector<dsp::Lanes> x(kChunk, dsp::Lanes{0.1, 0.1});
  x[static_cast<std::size_t>(at)][channel] = peak;
  return x;
}

/// Lanes are no lvalues to bind to.
double at(const std::vector<dsp::Lanes>& x, int n, int channel) {
  return x[static_cast<std::size_t>(n)][channel];
}

}  // namespace

TEST_CASE("without latency a peak on either channel, up or down, takes both down just to the ceiling") {
  for (const int channel : {0, 1})
    for (const double peak : {2.0, -2.0}) {
      Limiter limiter(kCeiling, 48000);
      std::vector<dsp::Lanes> x = chunk_of(peak, 20, channel);
      limiter.process(x.data());
      CHECK(std::fabs(at(x, 20, channel)) == doctest::Approx(kCeiling).epsilon(1e-12));
      CHECK(at(x, 20, 1 - channel) == doctest::Approx(0.1 * kCeiling / 2).epsilon(1e-12));
      CHECK(limiter.lowest_gain() == doctest::Approx(kCeiling / 2).epsilon(1e-12));
    }
}

TEST_CASE("it falls ahead of the peak by a chunk's share a sample, and recovers with 0.12 s") {
  Limiter limiter(kCeiling, 48000);
  std::vector<dsp::Lanes> x = chunk_of(2, 20, 0);
  limiter.process(x.data());
  const auto gain = [&](std::size_t n) { return x[n][1] / 0.1; };
  for (std::size_t n = 0; n < 20; ++n) {
    const double fall = kCeiling / 2 + static_cast<double>(20 - n) / kChunk;
    CHECK(gain(n) == doctest::Approx(std::min(1.0, fall)).epsilon(1e-9));
  }
  const auto recovered = [](double samples) {
    return 1 - (1 - kCeiling / 2) * std::exp(-samples / (kRecovery_s * 48000));
  };
  for (std::size_t n = 21; n < kChunk; ++n)
    CHECK(gain(n) == doctest::Approx(recovered(static_cast<double>(n) - 20)).epsilon(1e-9));
  for (int chunk = 0; chunk < 180; ++chunk) {
    x.assign(kChunk, dsp::Lanes{0.1, 0.1});
    limiter.process(x.data());
  }
  CHECK(gain(kChunk - 1) == doctest::Approx(recovered(180 * kChunk + kChunk - 21)).epsilon(1e-9));
  CHECK(limiter.lowest_gain() == doctest::Approx(gain(0)).epsilon(1e-12));
}

TEST_CASE("a sample at the ceiling is left alone, and so is what follows once the gain is back") {
  Limiter limiter(kCeiling, 48000);
  std::vector<dsp::Lanes> x = chunk_of(kCeiling, 5, 1);
  limiter.process(x.data());
  CHECK(at(x, 5, 1) == kCeiling);
  CHECK(at(x, 6, 1) == 0.1);
  CHECK(limiter.lowest_gain() == 1);
}

TEST_CASE("the last sample of a chunk is led up to like any other, the first is cut at once") {
  for (const int place : {0, kChunk - 1}) {
    Limiter limiter(kCeiling, 48000);
    std::vector<dsp::Lanes> x = chunk_of(2, place, 0);
    limiter.process(x.data());
    CHECK(at(x, place, 0) == doctest::Approx(kCeiling).epsilon(1e-12));
    if (place > 0)
      CHECK(at(x, kChunk - 2, 1) / 0.1 == doctest::Approx(kCeiling / 2 + 1.0 / kChunk).epsilon(1e-9));
    if (place == 0) CHECK(at(x, kChunk - 1, 1) / 0.1 < kCeiling / 2 + 0.02);
  }
}

TEST_CASE("with look-ahead the gain holds for 10 ms after a peak, recovers with 0.12 s, and is 1 again") {
  for (const int lookahead : {3, 6}) {
    CAPTURE(lookahead);
    LookaheadLimiter limiter(kCeiling, lookahead, 48000);
    std::vector<double> gains;  // at the end of every chunk
    for (int chunk = 0; chunk < 6000; ++chunk) {
      const double level = chunk == 20 ? 5.0 : 0.1;
      std::fill_n(limiter.input(), kChunk, dsp::Lanes{level, level});
      limiter.process(true);
      gains.push_back(limiter.gain().at(kChunk));
      CHECK(limiter.gain().lowest() == std::min(limiter.gain().at(0), limiter.gain().at(kChunk)));
    }
    const double lowest = *std::min_element(gains.begin(), gains.end());
    CHECK(lowest > 0.07);
    CHECK(lowest < 0.5 / 5);
    std::size_t held = 0;
    for (const double gain : gains) held += gain < lowest * (1 + 1e-9);
    // The hold, and what the look-ahead holds on top of it.
    CHECK(static_cast<double>(held) * kChunk / 48000 >= kHold_s);
    CHECK(static_cast<double>(held) * kChunk / 48000 <= kHold_s + (lookahead + 4) * kChunk / 48000.0);
    const auto end =
        static_cast<std::size_t>(std::find(gains.rbegin(), gains.rend(), lowest).base() - gains.begin());
    const std::size_t later = end + 200, much_later = later + 180;  // 0.12 s
    CHECK((1 - gains[much_later]) / (1 - gains[later]) == doctest::Approx(std::exp(-1)).epsilon(1e-6));
    CHECK(gains.back() == 1);
    CHECK(gains[end + 2400] < 1);
    CHECK(gains[end + 2550] == 1);  // within 1e-6 of it, which takes 13.7 times as long
  }
}

TEST_CASE(
    "with look-ahead silence is told as silence, a peak between the last sample and silence still counts") {
  LookaheadLimiter limiter(kCeiling, 3, 48000);
  const auto put = [&](double last) {
    std::fill_n(limiter.input(), kChunk, dsp::Lanes{});
    limiter.input()[kChunk - 1] = dsp::Lanes{last, last};
    return limiter.process(last != 0);
  };
  CHECK(put(0) == nullptr);
  CHECK(put(0.45) == nullptr);
  CHECK(put(0) == nullptr);
  CHECK(put(0) == nullptr);
  const dsp::Lanes* due = put(0);
  REQUIRE(due != nullptr);
  CHECK(due[kChunk - 1][0] == 0.45);
  CHECK(put(0) == nullptr);
}
