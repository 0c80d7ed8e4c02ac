// A second-order section, transposed direct form II, in double.
#pragma once

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

struct BiquadCoefficients {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

/// A filter of its own in each lane.
struct LaneCoefficients {
  LaneCoefficients() = default;
  LaneCoefficients(const BiquadCoefficients& first, const BiquadCoefficients& second) noexcept
      : b0{first.b0, second.b0},
        b1{first.b1, second.b1},
        b2{first.b2, second.b2},
        a1{first.a1, second.a1},
        a2{first.a2, second.a2} {}

  Lanes b0{1, 1}, b1{}, b2{}, a1{}, a2{};
};

/// Peaking equaliser of R. Bristow-Johnson's cookbook; frequency in Hz below sample_rate / 2. Thread: OFF.
BiquadCoefficients peaking(double frequency_hz, double gain_db, double q, double sample_rate);

/// `Sample`: double, or Lanes for two channels side by side.
template <class Sample, class Coefficients = BiquadCoefficients>
class BiquadOf {
 public:
  BiquadOf() = default;
  explicit BiquadOf(const Coefficients& c) noexcept : c_(c) {}

  Sample process(Sample x) noexcept {
    const Sample y = c_.b0 * x + s1_;
    s1_ = (c_.b1 * x - c_.a1 * y) + s2_;
    s2_ = c_.b2 * x - c_.a2 * y;
    return y;
  }

  /// `count` samples in place.
  void process(Sample* x, int count) noexcept {
    BiquadOf run = *this;  // its state stays in registers
    for (int n = 0; n < count; ++n) x[n] = run.process(x[n]);
    s1_ = run.s1_, s2_ = run.s2_;
  }

  /// Call once a chunk: what rings below -240 dB is dropped, so that silence ends in exact zeros and not in
  /// denormal numbers. False: it was no number, or so large that it would have been none; now it rests.
  bool settle() noexcept {
    const double energy = total(s1_ * s1_ + s2_ * s2_);
    const bool sound = energy < 1e100;
    if (!(energy >= 1e-24 && sound)) reset();
    return sound;
  }

  void reset() noexcept { s1_ = s2_ = Sample{}; }
  bool rests() const noexcept { return total(s1_ * s1_ + s2_ * s2_) == 0; }  ///< zeros give zeros

 private:
  Coefficients c_;
  Sample s1_{}, s2_{};
};

using Biquad = BiquadOf<double>;
using BiquadPair = BiquadOf<Lanes>;

}  // namespace rigsound::dsp
