// Units of measurement as DBC files write them.
#pragma once

#include <optional>
#include <string_view>

namespace rigsound::config {

/// What a unit measures. Turning and striking are both so many a second: r/min is Hz / 60.
enum class Quantity : unsigned char { kPressure, kFrequency, kRatio, kLength, kLevel, kOther };

struct Unit {
  Quantity quantity = Quantity::kOther;
  double factor = 1;  ///< value in bar, Hz, 1, m, dB = value in this unit * factor
};

/// Case, blanks and the degree sign do not count. kOther for a physical unit that no machine signal has (°C,
/// V, ...); nothing for no unit, and for what is no unit ("count", "state").
std::optional<Unit> unit_of(std::string_view text);

}  // namespace rigsound::config
