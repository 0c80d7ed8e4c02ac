// An axis of a chart: its range, its scale, and where its ticks are.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rigsound::chart {

struct Axis {
  enum class Scale { kLinear, kLog };
  std::string label;  ///< with the unit
  double low = 0, high = 1;
  Scale scale = Scale::kLinear;
  std::vector<std::pair<double, std::string>> ticks;  ///< where, and what it says

  /// 0...1 along the axis; values outside lie on its ends. Thread: any.
  double place(double value) const;
};

/// Ticks at round numbers, about `count` of them, from low to high. Thread: OFF.
Axis linear_axis(std::string label, double low, double high, int count = 5);

/// Ticks at 1, 2 and 5 of each decade; 0 < low < high. Thread: OFF.
Axis log_axis(std::string label, double low, double high);

/// A logarithmic axis of frequencies with ticks at `at` (Hz). Thread: OFF.
Axis frequency_axis(std::string label, double low, double high, const std::vector<double>& at);

/// Seconds; from two minutes on as minutes:seconds. Thread: OFF.
Axis time_axis(std::string label, double low_s, double high_s, int count);

}  // namespace rigsound::chart
