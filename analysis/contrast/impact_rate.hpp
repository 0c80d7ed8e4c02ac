// How often a sound of impacts strikes.
#pragma once

#include <vector>

namespace rigsound::analysis {

constexpr double kLowestRate_hz = 3, kHighestRate_hz = 125;

/// Impacts a second in `x` (kAnalysisRate, half a second at least), from the autocorrelation of its onsets
/// above 1 kHz, where a diesel is weak; a missed strike does not count. 0: nothing in it comes back
/// regularly. Thread: OFF.
double impact_rate_hz(const std::vector<float>& x);

}  // namespace rigsound::analysis
