// Compensation of the phase of the voice's crossover.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// `x` (kAnalysisRate) turned by the opposite phase of the voice's high-pass at `f_x` Hz, levels untouched.
/// Grains need it: what a cycle deviates by stands in a fixed phase to the orders it is played beside, and a
/// turned deviation of timing would sound as one of level. Thread: OFF.
std::vector<double> phase_advanced(const std::vector<double>& x, double f_x);

}  // namespace rigsound::analysis
