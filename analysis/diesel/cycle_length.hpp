// Whether a tracked cycle is one of 720 degrees, or two of them, or half of one.
#pragma once

#include "diesel/section.hpp"

namespace rigsound::analysis {

/// What alternates from one stretch of crank to the next, over what chance would leave of it (1: nothing).
struct Alternation {
  /// Between the halves of a cycle: 1 when the cycle given is two.
  double halves = 0;
  /// Between its quarters, in step with the halves: what a true cycle's halves would do.
  double quarters = 0;
  /// Between a cycle and the next: above 1 when the cycle given is half of one.
  double cycles = 0;
};

/// Thread: OFF.
Alternation alternation_of(const Section& section);

}  // namespace rigsound::analysis
