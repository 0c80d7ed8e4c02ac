// Quantiles of a list of figures.
#pragma once

#include <algorithm>
#include <vector>

namespace rigsound::analysis {

/// The value below which `part` (0 to 1) of at least one value lies, one of them. Thread: OFF.
template <class Value>
Value quantile(std::vector<Value> values, double part) {
  const auto at = values.begin() + static_cast<long>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The upper median of at least one value. Thread: OFF.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rigsound::analysis
