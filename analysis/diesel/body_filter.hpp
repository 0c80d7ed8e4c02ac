// The body over the crossover, as an all-pole filter common to all points (A7).
#pragma once

#include <vector>

#include "diesel/section.hpp"

namespace rigsound::analysis {

/// Autocorrelation r[0...order] of the open parts of `x` (already high-passed), r[0] = 1, white floor 1e-4.
/// Over `nyquist_hz` the spectrum is held, or the filter would spend its poles on the edge. Thread: OFF.
std::vector<double> body_autocorrelation(const std::vector<double>& x, const std::vector<char>& open,
                                         double nyquist_hz, int order);

/// A(z) of the mean of several autocorrelations, and what it leaves of a signal.
std::vector<double> common_body(const std::vector<std::vector<double>>& autocorrelations);
std::vector<double> whitened(const std::vector<double>& x, const std::vector<double>& A);

}  // namespace rigsound::analysis
