// Sixth-order Butterworth low-pass and high-pass; at one frequency the two add up to 1 in power.
#pragma once

#include <array>

#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

enum class Pass { kLow, kHigh };

class Butterworth6 {
 public:
  /// Bilinear transform of the analogue prototype, -3 dB at `frequency_hz` < sample_rate / 2. Thread: OFF.
  Butterworth6(Pass pass, double frequency_hz, double sample_rate) {
    const double t = tan(kPi * frequency_hz / sample_rate);
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      const double damping = 2 * cos(kPi * (2.0 * static_cast<double>(i) + 1) / 12);  // 1/Q of the pole pair
      const double norm = 1 / (1 + damping * t + t * t);
      const double gain = pass == Pass::kLow ? t * t * norm : norm;
      const double middle = pass == Pass::kLow ? 2 * gain : -2 * gain;
      sections_[i] = Biquad({gain, middle, gain, 2 * (t * t - 1) * norm, (1 - damping * t + t * t) * norm});
    }
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

}  // namespace rigsound::dsp
