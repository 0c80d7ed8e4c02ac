// A straight line through points of which some may be far off.
#pragma once

#include <vector>

namespace rigsound::analysis {

struct LinePoint {
  double x = 0, y = 0;
};

/// Theil and Sen's estimator: the weighted median of the slopes of all pairs further apart in x than
/// `least_apart`, each weighed by how far; almost three in ten points may be anywhere. 0 when there is no
/// such pair. Thread: OFF.
double median_slope(const std::vector<LinePoint>& points, double least_apart);

}  // namespace rigsound::analysis
