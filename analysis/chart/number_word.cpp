#include "chart/number_word.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rigsound::chart {

std::string number_word(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", value, digits);
  return text[0] == '-' ? "−" + text.substr(1) : text;
}

}  // namespace rigsound::chart
