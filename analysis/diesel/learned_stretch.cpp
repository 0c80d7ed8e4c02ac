#include <algorithm>
#include <cstddef>

#include "rigsound/analysis/diesel.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kStep_s = kLongestTake_s / 10;

/// Highest over lowest speed from `from_s` on, for kLongestTake_s.
double speed_range(const TimeTable& rpm, double from_s) {
  const auto row = [&](double s) {
    return std::lower_bound(rpm.time_s.begin(), rpm.time_s.end(), s) - rpm.time_s.begin();
  };
  const auto first = rpm.value.begin() + row(from_s), last = rpm.value.begin() + row(from_s + kLongestTake_s);
  if (first == last) return 1;
  const auto [low, high] = std::minmax_element(first, last);
  return *high / *low;
}

}  // namespace

Stretch learned_stretch(double recording_s, const TimeTable& rpm) {
  if (recording_s <= kLongestTake_s) return {};
  const double last_s = recording_s - kLongestTake_s;
  double start_s = last_s / 2, widest = 1;
  if (!rpm.time_s.empty()) widest = speed_range(rpm, start_s);
  for (int k = 0; !rpm.time_s.empty() && k * kStep_s <= last_s; ++k) {
    const double range = speed_range(rpm, k * kStep_s);
    if (range > widest) widest = range, start_s = k * kStep_s;
  }
  return {start_s, start_s + kLongestTake_s};
}

}  // namespace rigsound::analysis
