#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "mix/limiter.hpp"
#include "mix/mixer.hpp"
#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;

TEST_CASE("the peaking equaliser has its gain at its frequency and none far away") {
  const auto gain_db = [](double hz) {
    dsp::Biquad filter(dsp::peaking(1000, 6, 2, 48000));
    double in = 0, out = 0;
    for (int n = 0; n < 48000; ++n) {
      const double x = std::sin(2 * dsp::kPi * hz * n / 48000);
      const double y = filter.process(x);
      if (n > 24000) in += x * x, out += y * y;
    }
    return 10 * std::log10(out / in);
  };
  CHECK(gain_db(1000) == doctest::Approx(6).epsilon(0.001));
  CHECK(std::fabs(gain_db(50)) < 0.1);
  CHECK(std::fabs(gain_db(15000)) < 0.1);
}

TEST_CASE("the limiter without latency never passes its ceiling and leaves quiet sound alone, bit for bit") {
  mix::Limiter limiter(0.5, 48000);
  const dsp::RandomField random(3, 9);
  for (std::uint64_t chunk = 0; chunk < 2000; ++chunk) {
    const double level = chunk < 500 ? 0.1 : chunk < 1000 ? 3.0 : 0.1;
    dsp::Lanes x[kChunk], before[kChunk];
    for (std::uint64_t n = 0; n < kChunk; ++n) {
      const auto draw = [&](std::uint64_t c) {
        return level * (2 * random.uniform(chunk * kChunk + n, c) - 1);
      };
      before[n] = x[n] = dsp::Lanes{draw(0), draw(1)};
    }
    limiter.process(x);
    for (int c = 0; c < 2; ++c)
      for (int n = 0; n < kChunk; ++n) {
        REQUIRE(std::fabs(x[n][c]) <= 0.5 * (1 + 1e-12));
        if (const double now = x[n][c], then = before[n][c]; chunk < 500) REQUIRE(now == then);
      }
  }
  CHECK(limiter.lowest_gain() > 0.95);
}

TEST_CASE("an equaliser that rings beyond all bounds is dropped from the mix, counted, and heals") {
  EngineOptions options;
  options.mix.equaliser.assign(40, {1000, 24, 1});
  mix::Mixer mixer(options);
  mix::Buses buses{};
  buses.diesel.sounds = true;
  float out[kChunk * 2];
  const auto play = [&](double level, int chunks) {
    float peak = 0;
    for (int chunk = 0; chunk < chunks; ++chunk) {
      for (int n = 0; n < kChunk; ++n)
        buses.diesel.x[n] = level * dsp::sin(dsp::kTwoPi * 1000 / 48000 * (n + chunk * kChunk));
      mixer.process(buses, {1, 1}, out);
      for (const float x : out) {
        REQUIRE(std::isfinite(x));
        peak = std::max(peak, std::fabs(x));
      }
    }
    return peak;
  };
  play(1e29, 100);
  CHECK(mixer.take_dropped() > 0);
  play(1e-20, 75);  // 50 ms
  mixer.take_dropped();
  CHECK(play(1e-20, 100) > 0);
  CHECK(mixer.take_dropped() == 0);
}

TEST_CASE("pan keeps the power and reaches both ends") {
  for (const double pan : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
    EngineOptions options;
    options.booms = {{"boom", pan, 0, -1}};
    mix::Mixer mixer(options);
    mix::Buses buses{};
    buses.drill[0].sounds = true;
    for (double& x : buses.drill[0].x) x = 0.5;
    float out[kChunk * 2];
    for (int n = 0; n <= lookahead_frames(options); n += kChunk) mixer.process(buses, {1, 1}, out);
    const double left = static_cast<double>(out[10]), right = static_cast<double>(out[11]);
    CHECK(left * left + right * right == doctest::Approx(0.25).epsilon(1e-6));
    if (pan == -1) CHECK(right == doctest::Approx(0).scale(1));
    if (pan == 1) CHECK(left == doctest::Approx(0).scale(1));
  }
}
