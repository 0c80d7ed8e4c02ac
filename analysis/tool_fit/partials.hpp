// The clear partials of a ringing sound.
#pragma once

#include <vector>

namespace rigsound::analysis {

struct Partial {
  double hz = 0;
  double prominence_db = 0;  ///< over the median around it
};

/// Peaks of the spectrum after the first 4 ms of an impact (at kAnalysisRate), strongest first, at most 24.
/// Thread: OFF.
std::vector<Partial> clear_partials(const std::vector<double>& impact, double highest_hz);

}  // namespace rigsound::analysis
