// In place of the engine's: Emscripten 3.1 has no std::to_chars for double, and no locale that would change
// printf.
#include <cstdio>

#include "rigsound/machine/fields.hpp"

namespace rigsound {

std::string number_text(double x) {
  char digits[32];
  const int count = std::snprintf(digits, sizeof digits, "%.10g", x);
  return {digits, static_cast<std::size_t>(count)};
}

}  // namespace rigsound
