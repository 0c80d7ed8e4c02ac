// Seconds since the machine started, as all threads of the daemon count them.
#pragma once

#include <chrono>

namespace rigsound::daemon {

inline double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace rigsound::daemon
