// Figures of the distances between clicks.
#pragma once

#include <utility>
#include <vector>

#include "numeric/quantile.hpp"

namespace rigsound::analysis {

/// Periods: a gap below the first is no gap at all; one below the second is a double impact, or an echo.
constexpr double kShortestGap = 0.28, kDoubleBelow = 0.75;

/// Median distance between neighbours of an ascending list of at least two times, in its unit.
template <class Time>
double median_gap(const std::vector<Time>& times) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(static_cast<double>(times[i] - times[i - 1]));
  return median(std::move(gaps));
}

}  // namespace rigsound::analysis
