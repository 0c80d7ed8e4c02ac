// Weightings against the standard's table and formula, ballistics against its time constants.
#include "rigsound/sound_level_meter.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/weighting.hpp"
#include "rigsound/machine/limits.hpp"

using namespace rigsound;

namespace {

/// IEC 61672-1, table 3: A and C in dB at 10^(n / 10) Hz, n = 10...43.
constexpr double kTable[][2] = {
    {-70.4, -14.3}, {-63.4, -11.2}, {-56.7, -8.5}, {-50.5, -6.2}, {-44.7, -4.4}, {-39.4, -3.0}, {-34.6, -2.0},
    {-30.2, -1.3},  {-26.2, -0.8},  {-22.5, -0.5}, {-19.1, -0.3}, {-16.1, -0.2}, {-13.4, -0.1}, {-10.9, 0},
    {-8.6, 0},      {-6.6, 0},      {-4.8, 0},     {-3.2, 0},     {-1.9, 0},     {-0.8, 0},     {0, 0},
    {0.6, 0},       {1.0, -0.1},    {1.2, -0.2},   {1.3, -0.3},   {1.2, -0.5},   {1.0, -0.8},   {0.5, -1.3},
    {-0.1, -2.0},   {-1.1, -3.0},   {-2.5, -4.4},  {-4.3, -6.2},  {-6.6, -8.5},  {-9.3, -11.2}};

double gain_of(const dsp::BiquadCoefficients& c, double hz, double rate) {
  const std::complex<double> z = std::polar(1.0, -2 * M_PI * hz / rate);
  return std::abs((c.b0 + c.b1 * z + c.b2 * z * z) / (1.0 + c.a1 * z + c.a2 * z * z));
}

double db(double gain) { return 20 * std::log10(gain); }
double power_db(double power) { return 10 * std::log10(power); }

/// A stereo meter at 48 kHz after `seconds` of a 1 kHz sine of `amplitude` on the left.
void play(SoundLevelMeter& meter, double amplitude, double seconds) {
  std::vector<float> block(64 * 2, 0.0F);
  int n = 0;
  for (int b = 0; b < seconds * 750; ++b) {
    for (std::size_t i = 0; i < 64; ++i, ++n)
      block[2 * i] = static_cast<float>(amplitude * std::sin(2 * M_PI * 1000 / 48000 * n));
    meter.process(block.data(), 64);
  }
}

}  // namespace

TEST_CASE("the weightings are those of the standard") {
  for (int n = 10; n <= 43; ++n) {
    const double hz = std::pow(10, n / 10.0);
    CAPTURE(hz);
    CHECK(std::fabs(db(dsp::analogue_a_gain(hz)) - kTable[n - 10][0]) <= 0.06);
    CHECK(std::fabs(db(dsp::analogue_c_gain(hz)) - kTable[n - 10][1]) <= 0.06);
    for (const double rate : {32000.0, 44100.0, 48000.0, 96000.0, 192000.0}) {
      if (hz > 0.45 * rate) continue;
      CAPTURE(rate);
      const dsp::Weighting w = dsp::weighting(rate);
      const double c = db(gain_of(w.c[0], hz, rate) * gain_of(w.c[1], hz, rate));
      const double off_c = c - db(dsp::analogue_c_gain(hz));
      const double off_a = c + db(gain_of(w.a, hz, rate)) - db(dsp::analogue_a_gain(hz));
      // Class 1 allows 1 dB up to 4 kHz, 1.5 dB to 8 kHz, 2 dB to 12.5 kHz, 2.5 dB at 16 kHz, 3 dB at 20 kHz.
      const double allowed = hz < 1100 ? 0.1 : hz < 4500 ? 0.4 : hz < 8500 ? 0.8 : 1.2;
      CHECK(std::fabs(off_c) <= allowed);
      CHECK(std::fabs(off_a) <= allowed);
    }
  }
}

TEST_CASE("a sine of amplitude 1 on one channel reads 0 dB, channels add up in power") {
  SoundLevelMeter meter(48000, 2);
  play(meter, 1, 6);
  CHECK(power_db(meter.level().fast) == doctest::Approx(0).scale(1).epsilon(0.02));
  CHECK(power_db(meter.level().slow) == doctest::Approx(0).scale(1).epsilon(0.03));
  CHECK(meter.level().c_peak == doctest::Approx(1).epsilon(0.01));
  std::vector<float> block(48 * kChunk * 2);  // whole periods
  for (std::size_t i = 0; i < block.size() / 2; ++i)
    block[2 * i] = block[2 * i + 1] =
        static_cast<float>(std::sin(2 * M_PI * 1000 / 48000 * static_cast<double>(i)));
  for (int k = 0; k < 4; ++k) meter.process(block.data(), 48 * kChunk);
  CHECK(power_db(meter.level().mean) == doctest::Approx(3.01).epsilon(0.01));
  CHECK(meter.level().c_peak == doctest::Approx(2).epsilon(0.01));
}

TEST_CASE("fast and slow follow with 125 ms and 1 s, and fall 34.7 and 4.3 dB a second") {
  SoundLevelMeter meter(48000, 2);
  play(meter, 0.5, 0.125);
  CHECK(meter.level().fast == doctest::Approx(0.25 * (1 - std::exp(-1))).scale(0).epsilon(0.02));
  CHECK(meter.level().slow == doctest::Approx(0.25 * (1 - std::exp(-0.125))).scale(0).epsilon(0.02));
  play(meter, 0.5, 6);
  const SoundLevel before = meter.level();
  play(meter, 0, 0.5);
  CHECK(power_db(before.fast / meter.level().fast) == doctest::Approx(34.7 / 2).epsilon(0.02));
  CHECK(power_db(before.slow / meter.level().slow) == doctest::Approx(4.343 / 2).epsilon(0.02));
  play(meter, 0, 50);
  CHECK(meter.level().slow == 0);
  CHECK(meter.level().c_peak == 0);
}

TEST_CASE("a meter at rest hears a sound wherever it begins in a chunk, on either channel") {
  for (const int channels : {1, 2})
    for (int channel = 0; channel < channels; ++channel)
      for (const int frame : {0, 1, kChunk / 2 - 1, kChunk / 2, kChunk - 1}) {
        SoundLevelMeter meter(48000, channels);
        std::vector<float> block(static_cast<std::size_t>(kChunk * channels), 0.0F);
        meter.process(block.data(), kChunk);
        CHECK(meter.level().c_peak == 0);
        block[static_cast<std::size_t>(frame * channels + channel)] = 0.5F;
        meter.process(block.data(), kChunk);
        CAPTURE(channels);
        CAPTURE(frame);
        CHECK(meter.level().c_peak > 0.1);
        CHECK(meter.level().mean > 0);
      }
  SoundLevelMeter meter(48000, 1);
  const std::vector<float> loud(kChunk, 0.5F);
  meter.process(loud.data(), kChunk);
  CHECK(meter.level().c_peak > 0.1);
}
