// Figures of the distances between clicks.
#pragma once

#include <cstddef>
#include <vector>

#include "numeric/quantile.hpp"

namespace rigsound::analysis {

/// Periods: a gap below the first is no gap at all; one below the second is a double impact, or an echo.
constexpr double kShortestGap = 0.28, kDoubleBelow = 0.75;

/// Distances between neighbours of an ascending list of times, in its unit.
template <class Time>
std::vector<double> gaps_of(const std::vector<Time>& times) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(static_cast<double>(times[i] - times[i - 1]));
  return gaps;
}

/// Their median, of at least two times.
template <class Time>
double median_gap(const std::vector<Time>& times) {
  return median(gaps_of(times));
}

/// Of an ascending list the times that no other one precedes by less than 0.4 of the usual gap: the first
/// strikes of a machine that strikes twice, one soon after the other. The usual gap is that which seven in
/// ten do not exceed: where all strikes are double, half of the gaps are short.
template <class Time>
std::vector<Time> first_strikes(const std::vector<Time>& times) {
  if (times.size() < 3) return times;
  const double shortest = 0.4 * quantile(gaps_of(times), 0.7);
  std::vector<Time> first{times.front()};
  for (const Time t : times)
    if (static_cast<double>(t - first.back()) >= shortest) first.push_back(t);
  return first;
}

}  // namespace rigsound::analysis
