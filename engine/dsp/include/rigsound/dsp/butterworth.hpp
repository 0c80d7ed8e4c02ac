// Sixth-order Butterworth low-pass and high-pass; at one frequency the two add up to 1 in power.
#pragma once

#include <array>

#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

enum class Pass { kLow, kHigh };

/// Section i of 3: bilinear transform of the analogue prototype, -3 dB at `frequency_hz` < sample_rate / 2.
/// Thread: OFF.
inline BiquadCoefficients butterworth_section(Pass pass, std::size_t i, double frequency_hz,
                                              double sample_rate) {
  const double t = tan(kPi * frequency_hz / sample_rate);
  const double damping = 2 * cos(kPi * (2.0 * static_cast<double>(i) + 1) / 12);  // 1/Q of the pole pair
  const double norm = 1 / (1 + damping * t + t * t);
  const double gain = pass == Pass::kLow ? t * t * norm : norm;
  const double middle = pass == Pass::kLow ? 2 * gain : -2 * gain;
  return {gain, middle, gain, 2 * (t * t - 1) * norm, (1 - damping * t + t * t) * norm};
}

class Butterworth6 {
 public:
  Butterworth6(Pass pass, double frequency_hz, double sample_rate) {  ///< Thread: OFF
    for (std::size_t i = 0; i < sections_.size(); ++i)
      sections_[i] = Biquad(butterworth_section(pass, i, frequency_hz, sample_rate));
  }

  double process(double x) noexcept {  ///< Thread: RT
    for (Biquad& section : sections_) x = section.process(x);
    return x;
  }

  void reset() noexcept {
    for (Biquad& section : sections_) section.reset();
  }

 private:
  std::array<Biquad, 3> sections_;
};

/// Joins what belongs under a frequency and what belongs over it: both filters side by side.
class Crossover6 {
 public:
  Crossover6(double frequency_hz, double sample_rate) {  ///< Thread: OFF
    for (std::size_t i = 0; i < sections_.size(); ++i)
      sections_[i] =
          Section(LaneCoefficients(butterworth_section(Pass::kLow, i, frequency_hz, sample_rate),
                                   butterworth_section(Pass::kHigh, i, frequency_hz, sample_rate)));
  }

  /// y[n] += low-passed low[n] + high-passed high[n]. Thread: RT.
  void add(const float* low, const float* high, double* y, int count) noexcept {
    std::array<Section, 3> run = sections_;  // their state stays in registers
    for (int n = 0; n < count; ++n) {
      Lanes x = {static_cast<double>(low[n]), static_cast<double>(high[n])};
      for (Section& section : run) x = section.process(x);
      y[n] += total(x);
    }
    sections_ = run;
  }

  void reset() noexcept {  ///< Thread: RT
    for (Section& section : sections_) section.reset();
  }

 private:
  using Section = BiquadOf<Lanes, LaneCoefficients>;
  std::array<Section, 3> sections_;
};

}  // namespace rigsound::dsp
