// A second-order section, transposed direct form II, in double.
#pragma once

namespace rigsound::dsp {

struct BiquadCoefficients {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

/// Peaking equaliser of R. Bristow-Johnson's cookbook; frequency in Hz below sample_rate / 2. Thread: OFF.
BiquadCoefficients peaking(double frequency_hz, double gain_db, double q, double sample_rate);

class Biquad {
 public:
  Biquad() = default;
  explicit Biquad(const BiquadCoefficients& c) noexcept : c_(c) {}

  double process(double x) noexcept {
    const double y = c_.b0 * x + s1_;
    s1_ = (c_.b1 * x - c_.a1 * y) + s2_;
    s2_ = c_.b2 * x - c_.a2 * y;
    return y;
  }

  /// Call once a chunk: what rings below -240 dB is dropped, so that silence ends in exact zeros and not in
  /// denormal numbers; and what is no number, or so large that it will be none.
  void settle() noexcept {
    const double energy = s1_ * s1_ + s2_ * s2_;
    if (!(energy >= 1e-24 && energy < 1e100)) reset();
  }

  void reset() noexcept { s1_ = s2_ = 0; }
  bool rests() const noexcept { return s1_ == 0 && s2_ == 0; }  ///< zeros give zeros

 private:
  BiquadCoefficients c_;
  double s1_ = 0, s2_ = 0;
};

}  // namespace rigsound::dsp
