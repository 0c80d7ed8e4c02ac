// The middle of a list of figures.
#pragma once

#include <algorithm>
#include <vector>

namespace rigsound::analysis {

/// The upper median of at least one value. Thread: OFF.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rigsound::analysis
