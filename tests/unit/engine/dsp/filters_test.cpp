// Equaliser, weightings, prediction and interpolation against their formulas.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/interpolation_kernel.hpp"
#include "rigsound/dsp/linear_prediction.hpp"
#include "rigsound/dsp/weighting.hpp"

using namespace rigsound;
using Complex = std::complex<double>;

namespace {

double gain_of(const dsp::BiquadCoefficients& c, double hz, double rate) {
  const Complex z = std::polar(1.0, -2 * M_PI * hz / rate);
  return std::abs((c.b0 + c.b1 * z + c.b2 * z * z) / (1.0 + c.a1 * z + c.a2 * z * z));
}

double gain_of(const std::vector<double>& a, double hz, double rate) {
  Complex sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += a[k] * std::polar(1.0, -2 * M_PI * hz / rate * static_cast<double>(k));
  return 1 / std::abs(sum);
}

}  // namespace

TEST_CASE("the peaking equaliser is the bilinear image of its analogue bell") {
  for (const double gain_db : {-12.0, 6.0, 24.0})
    for (const double q : {0.5, 2.0, 10.0})
      for (const double hz : {20.0, 500.0, 990.0, 1000.0, 1100.0, 3000.0, 20000.0}) {
        CAPTURE(gain_db);
        CAPTURE(q);
        CAPTURE(hz);
        const double A = std::pow(10, gain_db / 40);
        const Complex s(0, std::tan(M_PI * hz / 48000) / std::tan(M_PI * 1000 / 48000));
        const double bell = std::abs((s * s + s * A / q + 1.0) / (s * s + s / (A * q) + 1.0));
        CHECK(gain_of(dsp::peaking(1000, gain_db, q, 48000), hz, 48000) ==
              doctest::Approx(bell).epsilon(1e-9));
      }
}

TEST_CASE("the upper weighting has the analogue gain at 0 Hz, at its pole and at half the rate") {
  constexpr double kPole_hz = 12194.217;
  for (const double rate : {32000.0, 48000.0, 192000.0}) {
    CAPTURE(rate);
    const dsp::BiquadCoefficients c = dsp::weighting(rate).c[1];
    const auto analogue = [](double hz) { return 1 / (1 + hz * hz / (kPole_hz * kPole_hz)); };
    CHECK(gain_of(c, kPole_hz, rate) / gain_of(c, 0, rate) ==
          doctest::Approx(analogue(kPole_hz)).epsilon(1e-9));
    CHECK(gain_of(c, rate / 2, rate) / gain_of(c, 0, rate) ==
          doctest::Approx(analogue(rate / 2)).epsilon(1e-9));
    CHECK(gain_of(c, 1000, rate) == doctest::Approx(1).epsilon(1e-9));
    // A double pole and a double zero, both real and inside the unit circle.
    CHECK(c.a1 * c.a1 == doctest::Approx(4 * c.a2).epsilon(1e-9));
    CHECK(c.b1 * c.b1 == doctest::Approx(4 * c.b0 * c.b2).epsilon(1e-9));
    CHECK(std::fabs(c.a2) < 1);
    CHECK(std::fabs(c.b2) <= std::fabs(c.b0));
  }
}

TEST_CASE("the lower weightings have the standard's poles, and zeros at 0 Hz") {
  constexpr double kLow_hz = 20.598997, kMiddle1_hz = 107.65265, kMiddle2_hz = 737.86223;
  for (const double rate : {32000.0, 48000.0, 192000.0}) {
    CAPTURE(rate);
    const dsp::Weighting w = dsp::weighting(rate);
    const auto pole = [rate](double hz) { return std::exp(-2 * M_PI * hz / rate); };
    CHECK(w.c[0].a1 == doctest::Approx(-2 * pole(kLow_hz)).epsilon(1e-12));
    CHECK(w.c[0].a2 == doctest::Approx(pole(kLow_hz) * pole(kLow_hz)).epsilon(1e-12));
    CHECK(w.a.a1 == doctest::Approx(-pole(kMiddle1_hz) - pole(kMiddle2_hz)).epsilon(1e-12));
    CHECK(w.a.a2 == doctest::Approx(pole(kMiddle1_hz) * pole(kMiddle2_hz)).epsilon(1e-12));
    for (const dsp::BiquadCoefficients& c : {w.c[0], w.a}) {
      CHECK(c.b1 == doctest::Approx(-2 * c.b0).epsilon(1e-12));
      CHECK(c.b2 == doctest::Approx(c.b0).epsilon(1e-12));
      CHECK(gain_of(c, 1000, rate) == doctest::Approx(1).epsilon(1e-9));
    }
  }
}

TEST_CASE("the analogue weightings are the product of their poles, 1 at 1 kHz") {
  const auto c = [](double hz) {
    const Complex s(0, hz);
    return std::abs(s * s / (std::pow(s + 20.598997, 2) * std::pow(s + 12194.217, 2)));
  };
  const auto a = [&](double hz) {
    const Complex s(0, hz);
    return c(hz) * std::abs(s * s / ((s + 107.65265) * (s + 737.86223)));
  };
  for (const double hz : {10.0, 100.0, 700.0, 1000.0, 5000.0, 20000.0}) {
    CAPTURE(hz);
    CHECK(dsp::analogue_c_gain(hz) == doctest::Approx(c(hz) / c(1000)).epsilon(1e-9));
    CHECK(dsp::analogue_a_gain(hz) == doctest::Approx(a(hz) / a(1000)).epsilon(1e-9));
  }
}

TEST_CASE("Levinson's recursion solves the normal equations and knows what is left") {
  const std::vector<double> r{2.0, 1.1, -0.3, 0.25, 0.6};
  const dsp::LinearPrediction model = dsp::levinson(r);
  REQUIRE(model.a.size() == r.size());
  CHECK(model.a[0] == 1);
  for (std::size_t lag = 0; lag < r.size(); ++lag) {
    double sum = 0;
    for (std::size_t k = 0; k < r.size(); ++k) sum += model.a[k] * r[lag > k ? lag - k : k - lag];
    CHECK(sum == doctest::Approx(lag == 0 ? model.error * r[0] : 0).scale(1).epsilon(1e-12));
  }
}

TEST_CASE("an all-pole model at another rate keeps its response in Hz, and its last value beyond") {
  const double radius = 0.95, at = 2 * M_PI * 3000 / 44100;
  std::vector<double> a{1, -2 * radius * std::cos(at), radius * radius};
  a.resize(64, 0.0);
  CHECK(dsp::all_pole_at_rate(a, 44100, 44100) == a);
  for (const double rate : {48000.0, 32000.0}) {
    CAPTURE(rate);
    const std::vector<double> b = dsp::all_pole_at_rate(a, 44100, rate);
    REQUIRE(b.size() == a.size());
    CHECK(b[0] == 1);
    const double level = gain_of(b, 3000, rate) / gain_of(a, 3000, 44100);
    for (const double hz : {500.0, 2000.0, 2900.0, 3100.0, 6000.0, 14000.0}) {
      CAPTURE(hz);
      CHECK(gain_of(b, hz, rate) / gain_of(a, hz, 44100) == doctest::Approx(level).epsilon(0.02));
    }
    if (rate > 44100)
      CHECK(gain_of(b, 23500, rate) / gain_of(a, 22050, 44100) == doctest::Approx(level).epsilon(0.05));
  }
}

TEST_CASE("the interpolation kernel is a Kaiser-windowed sinc whose weights add up to 1") {
  for (const double cut : {1.0, 0.8}) {
    constexpr int kTaps = 16, kPhases = 32;
    constexpr double kBeta = 8;
    const dsp::InterpolationKernel kernel(kTaps, kPhases, kBeta, cut);
    CHECK(kernel.taps() == kTaps);
    CHECK(kernel.first() == -7);
    for (const int row : {0, 1, 13, 31}) {
      CAPTURE(row);
      double w[kTaps], ideal[kTaps], sum = 0, scale = 0;
      kernel.weights(row / double(kPhases), w);
      for (int k = 0; k < kTaps; ++k) {
        const double t = kernel.first() + k - row / double(kPhases), inside = 1 - t * t / 64;
        const double window =
            inside > 0 ? std::cyl_bessel_i(0, kBeta * std::sqrt(inside)) / std::cyl_bessel_i(0, kBeta) : 0;
        ideal[k] = window * (t == 0 ? 1 : std::sin(M_PI * cut * t) / (M_PI * cut * t));
        sum += w[k], scale += ideal[k];
      }
      CHECK(sum == doctest::Approx(1).epsilon(1e-12));
      for (int k = 0; k < kTaps; ++k)
        CHECK(w[k] == doctest::Approx(ideal[k] / scale).scale(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("between two rows of its table the interpolation kernel is linear") {
  const dsp::InterpolationKernel kernel(24, 8, 9);
  double low[24], high[24], between[24];
  kernel.weights(3 / 8.0, low), kernel.weights(4 / 8.0, high), kernel.weights(3.25 / 8.0, between);
  for (int k = 0; k < 24; ++k)
    CHECK(between[k] == doctest::Approx(0.75 * low[k] + 0.25 * high[k]).scale(1).epsilon(1e-14));
}
