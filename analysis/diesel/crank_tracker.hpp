// The crank angle of a recording, from its sound.
#pragma once

#include <vector>

namespace rigsound::analysis {

struct CrankTrack {
  std::size_t first = 0;      ///< sample from which theta is known
  std::vector<double> theta;  ///< cycles of 720 degrees at samples first, first + 1, ...; starts near 0
  double correlation = 0;     ///< mean correlation of a cycle with the template it was aligned to, -1...1
  double rpm() const;         ///< mean over the track, at kAnalysisRate
};

/// Cycle frequency near `rpm` (within 10 %) at which the recording repeats best, r/min; 0 when it does not
/// repeat there at all. Thread: OFF.
double repeating_rpm(const std::vector<double>& x, double rpm);

/// Tracks a steady diesel from its mean speed: running template, then six rounds of alignment to the mean of
/// all cycles and of the neighbouring ones, smoothed. Accuracy on the simulator: below 0.5 degrees rms.
/// Thread: OFF.
CrankTrack track_steady(const std::vector<double>& x, double rpm);

/// Refines a logged speed (r/min at every sample) against neighbouring cycles only. Thread: OFF.
CrankTrack track_logged(const std::vector<double>& x, const std::vector<double>& rpm);

}  // namespace rigsound::analysis
