#include "rigsound/machine/fields.hpp"

#include <cmath>

namespace rigsound {

bool Range::holds(double x) const noexcept {
  if (zero && x == 0) return true;
  if (!(x >= min && x <= max)) return false;
  return step == 0 || std::floor(x / step) * step == x;
}

std::string Range::text() const {
  std::string text =
      (zero && (min > 0 || max < 0) ? "0 or " : "") + number_text(min) + "..." + number_text(max);
  if (*unit != '\0') text.append(" ").append(unit);
  if (step > 1) text += ", a multiple of " + number_text(step);
  return text;
}

std::string Range::problem(double x) const {
  const bool broken = step == 1 && x >= min && x <= max && x != std::floor(x);
  return "is " + number_text(x) + (*unit == '\0' ? "" : " ") + unit + ", expected " +
         (broken ? "a whole number, " : "") + text();
}

}  // namespace rigsound
