// Flat tops: what a recorder could not hold.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// Share of the samples (0...1) on tops at least two samples wide, at the highest level there is, full
/// scale or below. Measure at the recorder's own rate: another rate rounds them. Thread: OFF.
double clipped_share(const std::vector<float>& x);

}  // namespace rigsound::analysis
