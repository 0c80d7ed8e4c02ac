// Time since the machine started, as all live readings and threads count it.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>

namespace rigsound {

/// Thread: any.
inline double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline std::int64_t monotonic_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

/// The same, but that it counts while the machine is suspended. Thread: any, RT.
inline std::int64_t boottime_ns() noexcept {
  timespec t{};
  ::clock_gettime(CLOCK_BOOTTIME, &t);
  return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
}

}  // namespace rigsound
