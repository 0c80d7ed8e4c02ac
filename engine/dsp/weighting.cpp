#include "rigsound/dsp/weighting.hpp"

#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {
namespace {

constexpr double kLow_hz = 20.598997, kMiddle1_hz = 107.65265, kMiddle2_hz = 737.86223, kHigh_hz = 12194.217;
constexpr double kReference_hz = 1000;

double pole_of(double hz, double sample_rate) { return exp(-kTwoPi * hz / sample_rate); }

/// Zeros at 0 Hz, real poles.
BiquadCoefficients highpass(double pole1, double pole2) {
  return {1, -2, 1, -(pole1 + pole2), pole1 * pole2};
}

/// The analogue filter's real pole twice. Each section of one pole p and one zero has the analogue gain at 0
/// Hz, at `hz` and at half the rate. With phi = sin^2(w / 2) its gain squared is
///   ((1 - phi) + top^2 r phi) / ((1 - phi) + r phi), sqrt r = (1 + p) / (1 - p).
BiquadCoefficients lowpass(double hz, double sample_rate) {
  const double octave = sample_rate / 2 / hz, top2 = 1 / (1 + octave * octave);
  const double s = sin(kPi * hz / sample_rate), phi = s * s;
  const double r = std::sqrt((1 - phi) * 0.5 / (phi * (0.5 - top2)));
  const double p = (r - 1) / (r + 1), top = std::sqrt(top2);
  const double b0 = (1 - p + top * (1 + p)) / 2, b1 = (1 - p - top * (1 + p)) / 2;
  return {b0 * b0, 2 * b0 * b1, b1 * b1, -2 * p, p * p};
}

double gain_at(const BiquadCoefficients& c, double w) {
  const auto size = [w](double k0, double k1, double k2) {
    const double re = k0 + k1 * cos(w) + k2 * cos(2 * w), im = k1 * sin(w) + k2 * sin(2 * w);
    return std::sqrt(re * re + im * im);
  };
  return size(c.b0, c.b1, c.b2) / size(1, c.a1, c.a2);
}

BiquadCoefficients unity_at_reference(BiquadCoefficients c, double sample_rate) {
  const double gain = gain_at(c, kTwoPi * kReference_hz / sample_rate);
  c.b0 /= gain, c.b1 /= gain, c.b2 /= gain;
  return c;
}

double c_gain(double f2) { return f2 / ((f2 + kLow_hz * kLow_hz) * (1 + f2 / (kHigh_hz * kHigh_hz))); }
double a_gain(double f2) {
  return c_gain(f2) * f2 / std::sqrt((f2 + kMiddle1_hz * kMiddle1_hz) * (f2 + kMiddle2_hz * kMiddle2_hz));
}

}  // namespace

Weighting weighting(double sample_rate) {
  const double low = pole_of(kLow_hz, sample_rate);
  const double middle1 = pole_of(kMiddle1_hz, sample_rate), middle2 = pole_of(kMiddle2_hz, sample_rate);
  return {{unity_at_reference(highpass(low, low), sample_rate),
           unity_at_reference(lowpass(kHigh_hz, sample_rate), sample_rate)},
          unity_at_reference(highpass(middle1, middle2), sample_rate)};
}

double analogue_a_gain(double hz) { return a_gain(hz * hz) / a_gain(kReference_hz * kReference_hz); }
double analogue_c_gain(double hz) { return c_gain(hz * hz) / c_gain(kReference_hz * kReference_hz); }

}  // namespace rigsound::dsp
