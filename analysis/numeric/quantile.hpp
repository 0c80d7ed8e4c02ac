// Quantiles of a list of figures. Thread: OFF.
#pragma once

#include <algorithm>
#include <vector>

namespace rigsound::analysis {

/// The value below which `part` (0 to 1) of at least one value lies, one of them.
template <class Value>
Value quantile(std::vector<Value> values, double part) {
  const auto at = values.begin() + static_cast<long>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The upper median of at least one value: one of them.
template <class Value>
Value upper_median(std::vector<Value> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The median of at least one value; of an even number, the mean of the middle two.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace rigsound::analysis
