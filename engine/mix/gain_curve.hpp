// The gain of a limiter over one chunk.
#pragma once

#include <algorithm>

#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// A piece of a quadratic B-spline: gains and slopes join without a step, and none leaves the range of the
/// three points it follows.
struct GainCurve {
  double start = 1, slope = 0, bend = 0;  ///< start + n (slope + n bend) at frame n

  static GainCurve through(double before, double here, double after) noexcept {
    return {(before + here) / 2, (here - before) / kChunk,
            (before - 2 * here + after) / (2.0 * kChunk * kChunk)};
  }
  bool is_one() const noexcept { return start == 1 && slope == 0 && bend == 0; }
  double at(int n) const noexcept { return start + n * (slope + n * bend); }
  double lowest() const noexcept { return std::min(start, at(kChunk)); }  ///< of its ends
};

}  // namespace rigsound::mix
