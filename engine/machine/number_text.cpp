// Apart from the rest: not every standard library can do it (tools/library/wasm).
#include <charconv>

#include "rigsound/machine/fields.hpp"

namespace rigsound {

std::string number_text(double x) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, x, std::chars_format::general, 10);
  return {digits, end.ptr};
}

}  // namespace rigsound
