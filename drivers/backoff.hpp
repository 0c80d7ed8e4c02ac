// The pause between attempts to open a device that is missing.
#pragma once

#include <algorithm>
#include <cstdint>

namespace rigsound {

/// From 0.1 s doubling to 5 s. Knows no clock: the caller says what time it is. Thread: one at a time.
class Backoff {
 public:
  bool due(std::int64_t now_ms) const { return now_ms >= next_ms_; }
  std::int64_t left_ms(std::int64_t now_ms) const { return std::max<std::int64_t>(0, next_ms_ - now_ms); }

  /// The next attempt is due after the pause, which then doubles.
  void failed(std::int64_t now_ms) {
    next_ms_ = now_ms + pause_ms_;
    pause_ms_ = std::min(2 * pause_ms_, kLongest_ms);
  }
  /// The device works: should it be lost, the pauses are short again.
  void worked(std::int64_t now_ms) {
    next_ms_ = now_ms + kFirst_ms;
    pause_ms_ = kFirst_ms;
  }

 private:
  static constexpr std::int64_t kFirst_ms = 100, kLongest_ms = 5000;

  std::int64_t next_ms_ = 0, pause_ms_ = kFirst_ms;
};

}  // namespace rigsound
