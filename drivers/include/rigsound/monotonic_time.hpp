// Seconds since the machine started, as all live readings and threads count them.
#pragma once

#include <chrono>

namespace rigsound {

inline double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace rigsound
