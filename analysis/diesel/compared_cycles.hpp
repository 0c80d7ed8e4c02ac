// A recording and its model as cycles that begin at the same crank angle, ready to be compared.
#pragma once

#include "diesel/likeness.hpp"
#include "diesel/section.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound::analysis {

/// The cycles of `section`, turned to the crank angle of `point`, N angle samples each. Thread: OFF.
CyclicSound recorded_cycles(const Section& section, const DieselPoint& point, int N);

/// What the diesel's voice makes of `model` at `rpm` (r/min) and `load` (0...1): a little more than so many
/// cycles. Thread: OFF.
Section played_section(const DieselModel& model, double rpm, double load, int cycles, unsigned seed);

/// The same at the speed and load of `point`, turned to its crank angle. Thread: OFF.
CyclicSound played_cycles(const DieselModel& model, const DieselPoint& point, int cycles, unsigned seed);

}  // namespace rigsound::analysis
