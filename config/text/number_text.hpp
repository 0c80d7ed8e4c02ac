// Numbers as messages write them.
#pragma once

#include <limits>
#include <sstream>
#include <string>

namespace rigsound::config {

inline std::string number_text(double x) {
  std::ostringstream out;
  out.precision(10);
  out << x;
  return out.str();
}

/// "from 1 to 20", "of at least 0", "of at most 3".
inline std::string range_text(double min, double max) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  if (max >= kHuge) return "of at least " + number_text(min);
  if (min <= -kHuge) return "of at most " + number_text(max);
  return "from " + number_text(min) + " to " + number_text(max);
}

}  // namespace rigsound::config
