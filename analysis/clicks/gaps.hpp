// Figures of the distances between clicks.
#pragma once

#include <algorithm>
#include <vector>

namespace rigsound::analysis {

/// Periods: a gap below the first is no gap at all; one below the second is a double strike, or an echo.
constexpr double kShortestGap = 0.28, kDoubleBelow = 0.75;

/// Median distance between neighbours of an ascending list of at least two times, in its unit.
template <class Time>
double median_gap(const std::vector<Time>& times) {
  std::vector<double> gaps;
  for (size_t i = 1; i < times.size(); ++i) gaps.push_back(static_cast<double>(times[i] - times[i - 1]));
  std::sort(gaps.begin(), gaps.end());
  const size_t half = gaps.size() / 2;
  return gaps.size() % 2 ? gaps[half] : 0.5 * (gaps[half - 1] + gaps[half]);
}

}  // namespace rigsound::analysis
