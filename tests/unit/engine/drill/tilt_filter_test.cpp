// A tilt is a straight line over the octaves, costs nothing when it is none, and keeps a bank's level.
#include "drill/tilt_filter.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "drill/click_spectrum.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/machine/limits.hpp"
#include "scene/tilted_norm.hpp"

using namespace rigsound;
using namespace rigsound::drill;

namespace {

std::vector<double> tilted(double db_per_octave, std::vector<double> x, double rate) {
  TiltFilter filter(rate);
  x.resize((x.size() + kChunk - 1) / kChunk * kChunk);
  for (std::size_t n = 0; n < x.size(); n += kChunk) filter.process(db_per_octave, x.data() + n);
  return x;
}

double level_db(const std::vector<double>& x, double hz, double rate) {
  std::complex<double> sum;
  for (std::size_t n = 0; n < x.size(); ++n)
    sum += x[n] * std::polar(1.0, -2 * M_PI * hz / rate * static_cast<double>(n));
  return 20 * std::log10(std::abs(sum));
}

double norm(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum);
}

/// Decaying noise through a one-pole low-pass, as clicks are.
ClickBank noise_bank(double pole) {
  ClickBank bank;
  const dsp::RandomField random(3, 9);
  for (std::uint64_t click = 0; click < 16; ++click) {
    std::vector<double> x(4096);
    double low = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      low = pole * low + random.normal(click * 10000 + n, 0);
      x[n] = low * std::exp(-0.004 * static_cast<double>(n));
    }
    const double unit = norm(x);
    std::vector<float> samples;
    for (const double v : x) samples.push_back(static_cast<float>(v / unit));
    bank.clicks.push_back(samples);
  }
  return bank;
}

}  // namespace

TEST_CASE("the filter is a straight line over the octaves from 160 Hz to 8 kHz, at any rate") {
  for (const double rate : {44100.0, 48000.0, 96000.0})
    for (const double tilt : {-6.0, -2.0, 3.0}) {
      std::vector<double> click(16384);
      click[0] = 1;
      const std::vector<double> y = tilted(tilt, click, rate);
      for (const double hz : {160.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0}) {
        CAPTURE(rate);
        CAPTURE(tilt);
        CAPTURE(hz);
        const double wanted = tilt * std::log2(hz / 125);
        CHECK(std::fabs(level_db(y, hz, rate) - wanted) <
              1 + std::fabs(tilt) * (hz < 200 || hz > 5000 ? 0.6 : 0.2));
        CHECK(std::fabs(10 * std::log10(tilt_power(tilt, hz)) - level_db(y, hz, rate)) <
              (hz < 5000 ? 0.3 : 1.5));
      }
    }
}

TEST_CASE("no tilt leaves every bit, and a tilt that went leaves silence") {
  TiltFilter filter(48000);
  double x[kChunk], same[kChunk];
  const dsp::RandomField random(1, 1);
  for (int n = 0; n < kChunk; ++n) x[n] = same[n] = random.normal(static_cast<std::uint64_t>(n), 0);
  filter.process(0, x);
  for (int n = 0; n < kChunk; ++n) CHECK(x[n] == same[n]);
  CHECK(filter.rests());
  filter.process(-4, x);
  CHECK_FALSE(filter.rests());
  for (int chunk = 0; chunk < 400 && !filter.rests(); ++chunk) {
    std::fill(x, x + kChunk, 0.0);
    filter.process(-4, x);
  }
  CHECK(filter.rests());
  for (const double v : x) CHECK(std::fabs(v) < 1e-12);  // which the layer leaves out
}

TEST_CASE("the spectrum's slope of filtered noise, and the level it has after a tilt") {
  const double white = spectral_tilt(noise_bank(0));
  CHECK(std::fabs(white) < 0.4);
  // 1 / |1 - 0.999 z^-1|^2 falls by 6 dB an octave.
  CHECK(spectral_tilt(noise_bank(0.999)) - white == doctest::Approx(-6).epsilon(0.07));
  const ClickBank bank = noise_bank(0.9);
  for (const double tilt : {-8.0, -3.3, 0.0, 2.1}) {
    double ratio = 0;
    for (const Click& click : bank.clicks)
      ratio += norm(tilted(tilt, {click.begin(), click.end()}, bank.sample_rate)) / 16;
    CAPTURE(tilt);
    CHECK(std::fabs(20 / std::log(10.0) *
                    (scene::TiltedNorm(drill::ClickSpectrum(bank)).ln(tilt) - std::log(ratio))) < 0.6);
  }
}
