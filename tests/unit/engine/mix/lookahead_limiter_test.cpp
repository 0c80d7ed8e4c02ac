// The ceiling as a true-peak meter sees it, and what the limiter does to the sound for it.
#include "mix/lookahead_limiter.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <vector>

#include "engine/heard.hpp"
#include "engine/mix/true_peak_meter.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;
using namespace rigsound::mix;
using namespace rigsound::tests;

namespace {

constexpr double kTruePeakCeiling = 0.5;

/// What the limiter makes of x(n) on the left and half of it on the right, so many chunks of it; left
/// channel.
std::vector<double> limited(const std::function<double(int)>& x, int chunks, int lookahead = 3) {
  LookaheadLimiter limiter(kTruePeakCeiling, lookahead, kRate);
  std::vector<double> out;
  for (int chunk = 0; chunk < chunks; ++chunk) {
    bool sounds = false;
    for (int n = 0; n < kChunk; ++n) {
      const double sample = x(chunk * kChunk + n);
      limiter.input()[n] = dsp::Lanes{sample, sample / 2};
      sounds = sounds || sample != 0;
    }
    const dsp::Lanes* due = limiter.process(sounds);
    for (int n = 0; n < kChunk; ++n) out.push_back(due ? limiter.gain().at(n) * due[n][0] : 0);
  }
  return out;
}

double true_peak_of(const std::vector<double>& x) {
  tests::TruePeakMeter meter;
  for (const double sample : x) meter.add(sample);
  return meter.peak();
}

double over_ceiling_db(const std::vector<double>& x) {
  return dsp::db_of_gain(true_peak_of(x) / kTruePeakCeiling);
}

/// Harmonics 2...10 against the fundamental, dB, in a Hann window.
double distortion_db(const std::vector<double>& x, std::size_t from, double hz) {
  const auto power = [&](double f) {
    double c = 0, s = 0;
    for (std::size_t n = from; n < x.size(); ++n) {
      const double place = static_cast<double>(n - from) / static_cast<double>(x.size() - from);
      const double y = x[n] * (1 - dsp::cos(dsp::kTwoPi * place));
      c += y * dsp::cos(dsp::kTwoPi * f * static_cast<double>(n) / kRate);
      s += y * dsp::sin(dsp::kTwoPi * f * static_cast<double>(n) / kRate);
    }
    return c * c + s * s;
  };
  double sum = 0;
  for (int k = 2; k <= 10; ++k) sum += power(k * hz);
  return 10 * std::log10(sum / power(hz));
}

}  // namespace

TEST_CASE("true peaks are those of the meter") {
  const dsp::RandomField random(5, 1);
  tests::TruePeakMeter left, right;
  std::vector<dsp::Lanes> x(TruePeak::kPast + kChunk, dsp::Lanes{});
  TruePeak peak;
  double most = 0;
  for (std::uint64_t n = 0; n < 200 * kChunk; ++n) {
    const double level = n % 1000 < 20 ? 3 : 0.1;
    const dsp::Lanes frame = {level * random.normal(n, 0), level * random.normal(n, 2)};
    left.add(frame[0]), right.add(frame[1]);
    x[TruePeak::kPast + n % kChunk] = frame;
    if (n % kChunk != kChunk - 1) continue;
    most = std::max(most, peak.of(x.data() + TruePeak::kPast, 0.0));
    std::copy(x.end() - TruePeak::kPast, x.end(), x.begin());
    REQUIRE(most >= std::max(left.peak(), right.peak()) * (1 - 1e-12));
  }
  // Beyond the meter it knows the samples themselves.
  CHECK(most == doctest::Approx(std::max(left.peak(), right.peak())).epsilon(0.05));
}

TEST_CASE(
    "a true peak is at least the largest sample, wherever in a chunk and on whichever channel that is") {
  for (int at = 0; at < kChunk; ++at)
    for (const int channel : {0, 1})
      for (const double least : {0.0, 5.0}) {
        std::vector<dsp::Lanes> x(TruePeak::kPast + kChunk, dsp::Lanes{});
        x[static_cast<std::size_t>(TruePeak::kPast + at)][channel] = -1;
        TruePeak peak;
        CAPTURE(at);
        CHECK(peak.of(x.data() + TruePeak::kPast, least) >= 1);
      }
}

TEST_CASE("what is under the ceiling passes bit for bit, later by the look-ahead") {
  for (const int lookahead : {3, 4, 12}) {
    CAPTURE(lookahead);
    const auto x = [](int n) { return n % 700 < 300 ? 0.3 * dsp::sin(0.1 * n) : 0.0; };
    const std::vector<double> y = limited(x, 300, lookahead);
    for (int n = 0; n < 300 * kChunk; ++n) {
      const int played = n - lookahead * kChunk;
      REQUIRE(y[static_cast<std::size_t>(n)] == (played < 0 ? 0 : x(played)));
    }
  }
}

TEST_CASE("no true peak passes the ceiling") {
  const dsp::RandomField random(9, 2);
  const auto noise = [&](int n) { return random.normal(static_cast<std::uint64_t>(n), 0); };
  for (const int lookahead : {3, 5, 12}) {
    CAPTURE(lookahead);
    // A quarter of the rate, whose samples miss its peaks by 3 dB.
    CHECK(over_ceiling_db(limited([](int n) { return 4 * dsp::sin(dsp::kPi / 2 * n + dsp::kPi / 4); }, 500,
                                  lookahead)) <= 0);
    // Full-band noise whose level is another one, within 240 dB, every few samples or every few chunks.
    for (const int hold : {7, 50, 200, 3000})
      CHECK(over_ceiling_db(limited(
                [&](int n) {
                  const double level = random.uniform(static_cast<std::uint64_t>(n / hold), 3);
                  return noise(n) * dsp::exp(27 * (level - 0.5));
                },
                5000, lookahead)) <= 0);
  }
}

TEST_CASE("nor that of the worst signal there is: a filter's own signs at the target, then a leap") {
  for (int phase = 0; phase < 2; ++phase)
    for (int at = 0; at < 2 * kChunk; ++at)
      for (const double leap : {1.5, 10.0, 1e6}) {
        const auto x = [&](int n) {
          const int k = (n + at) % kTruePeakTaps;
          const double sign = kTruePeakPhase[phase][k] < 0 ? -1 : 1;
          return sign * kTruePeakCeiling * (1 - 0.008) / kTruePeakSpread * (n > 40 * kChunk ? leap : 1);
        };
        REQUIRE(over_ceiling_db(limited(x, 60)) <= 0);
      }
}

TEST_CASE("the gain has neither step nor corner") {
  LookaheadLimiter limiter(kTruePeakCeiling, 3, kRate);
  double before = 1, slope_before = 0, steepest = 0, sharpest = 0;
  for (int chunk = 0; chunk < 3000; ++chunk) {
    const double level = chunk % 500 < 3 ? 50 : 0.4;
    for (int n = 0; n < kChunk; ++n) limiter.input()[n] = dsp::Lanes{level, 0};
    limiter.process(true);
    for (int n = 0; n < kChunk; ++n) {
      const double gain = limiter.gain().at(n), slope = gain - before;
      steepest = std::max(steepest, std::fabs(slope));
      sharpest = std::max(sharpest, std::fabs(slope - slope_before));
      before = gain, slope_before = slope;
    }
  }
  CHECK(steepest > 0.5 / kChunk);  // it did fall by nearly 1
  CHECK(steepest <= 1.0 / kChunk);
  CHECK(sharpest <= 1.0 / (kChunk * kChunk) + 1e-12);
}

TEST_CASE("a tone 12 dB over the ceiling is turned down, not bent") {
  const std::size_t settled = static_cast<std::size_t>((0.002 + 0.02) * kRate);
  for (const double hz : {1000.0, 997.0, 100.0}) {
    CAPTURE(hz);
    const auto tone = [hz](int n) { return 4 * kTruePeakCeiling * dsp::sin(dsp::kTwoPi * hz / kRate * n); };
    const std::vector<double> y = limited(tone, 1500);
    CHECK(over_ceiling_db(y) <= 0);
    CHECK(over_ceiling_db(y) > -0.1);
    const double thd_db = distortion_db(y, settled, hz);
    CHECK(thd_db <= -60);
    MESSAGE("THD of " << hz << " Hz 12 dB over the ceiling, from 20 ms on: " << thd_db << " dB");
  }
}
