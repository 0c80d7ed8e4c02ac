// A control that reaches its target in a straight line, sample by sample.
#pragma once

#include <algorithm>

#include "rigsound/dsp/ramp.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::tool {

class RampedCurve {
 public:
  /// `step`: most it moves from one sample to the next.
  RampedCurve(double value, double step) noexcept : value_(value), step_(step) {
    std::fill(curve_, curve_ + kChunk, value);
  }

  /// The next kChunk values. Thread: RT.
  void process(double target) noexcept {
    if (rests_ && target == value_) return;
    rests_ = target == value_;
    for (double& c : curve_) c = value_ = dsp::step_towards(value_, target, step_);
  }

  const double* curve() const noexcept { return curve_; }

  /// All of the curve is `value`.
  bool rests_at(double value) const noexcept { return rests_ && value_ == value; }

 private:
  double value_, step_;
  bool rests_ = true;
  double curve_[kChunk];
};

}  // namespace rigsound::tool
