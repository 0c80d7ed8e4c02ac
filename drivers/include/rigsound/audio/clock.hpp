// Monotonic time, replaceable so that tests need not wait.
#pragma once

#include <cstdint>

namespace rigsound::audio {

class Clock {
 public:
  virtual ~Clock() = default;
  virtual std::int64_t now_ns() noexcept = 0;                   ///< Thread: RT
  virtual void sleep_until_ns(std::int64_t when) noexcept = 0;  ///< Thread: RT
};

/// CLOCK_MONOTONIC; sleeps to absolute deadlines.
class MonotonicClock : public Clock {
 public:
  std::int64_t now_ns() noexcept override;
  void sleep_until_ns(std::int64_t when) noexcept override;
};

/// Turns a clock into the pace of blocks: block k is due k block lengths after the first. Nobody hears them,
/// so they go by in groups of at most 10 ms: waking up costs more than a silent block. A caller that is late
/// by more than a second starts a new count instead of racing after it. Thread: RT.
class Pacer {
 public:
  Pacer(Clock& clock, double rate_hz, int block_frames);

  void start(std::int64_t ahead_ns = 0) noexcept;  ///< from now on, or from later
  void wait() noexcept;                            ///< after each block, until the group it ends is due

 private:
  Clock& clock_;
  double block_ns_;
  std::int64_t group_;  // blocks
  std::int64_t origin_ns_ = 0;
  std::int64_t blocks_ = 0;
};

}  // namespace rigsound::audio
