#include "rigsound/log/log_note.hpp"

#include <cstdint>

namespace rigsound::log {

std::string seconds_text(double seconds) {
  const auto tenths = static_cast<std::int64_t>(seconds * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace rigsound::log
