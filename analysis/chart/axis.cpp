#include "chart/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigsound::chart {
namespace {

constexpr double kMinutesFrom_s = 120;

void add_multiples(Axis& axis, double step) {
  for (double t = std::ceil(axis.low / step - 1e-9) * step; t <= axis.high + 1e-9 * step; t += step)
    axis.ticks.emplace_back(
        t, fmt::format("{}{:g}", t < -1e-9 * step ? "−" : "", std::fabs(t) < 1e-9 * step ? 0 : std::fabs(t)));
}

}  // namespace

double Axis::place(double value) const {
  const double v = std::clamp(value, low, high);
  if (scale == Scale::kLog) return std::log(v / low) / std::log(high / low);
  return (v - low) / (high - low);
}

Axis linear_axis(std::string label, double low, double high, int count) {
  Axis axis{std::move(label), low, high, Axis::Scale::kLinear, {}};
  const double rough = (high - low) / count, decade = std::pow(10, std::floor(std::log10(rough)));
  add_multiples(axis, decade * (rough / decade < 1.5   ? 1
                                : rough / decade < 3.5 ? 2
                                : rough / decade < 7.5 ? 5
                                                       : 10));
  return axis;
}

Axis log_axis(std::string label, double low, double high) {
  Axis axis{std::move(label), low, high, Axis::Scale::kLog, {}};
  for (double decade = std::floor(std::log10(low)); decade <= std::log10(high) + 1e-9; ++decade)
    for (const double digit : {1.0, 2.0, 5.0})
      if (const double v = digit * std::pow(10, decade); v > low * (1 - 1e-9) && v < high * (1 + 1e-9))
        axis.ticks.emplace_back(v, fmt::format("{:g}", v));
  return axis;
}

Axis frequency_axis(std::string label, double low, double high, const std::vector<double>& at) {
  Axis axis{std::move(label), low, high, Axis::Scale::kLog, {}};
  for (const double f : at)
    axis.ticks.emplace_back(f, f >= 1000 ? fmt::format("{:g}k", f / 1000) : fmt::format("{:g}", f));
  return axis;
}

Axis time_axis(std::string label, double low_s, double high_s, int count) {
  if (high_s - low_s < kMinutesFrom_s) return linear_axis(std::move(label), low_s, high_s, count);
  Axis axis{std::move(label), low_s, high_s, Axis::Scale::kLinear, {}};
  double step = 10;
  for (const double longer : {15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1200.0, 1800.0, 3600.0, 7200.0, 14400.0})
    if ((high_s - low_s) / step > count) step = longer;
  add_multiples(axis, step);
  for (auto& [seconds, says] : axis.ticks) {
    const long whole = std::lround(seconds);
    says = whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return axis;
}

}  // namespace rigsound::chart
