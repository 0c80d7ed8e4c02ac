// Time since the machine started, as all live readings and threads count it.
#pragma once

#include <chrono>
#include <cstdint>

namespace rigsound {

/// Thread: any.
inline double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline std::int64_t monotonic_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace rigsound
