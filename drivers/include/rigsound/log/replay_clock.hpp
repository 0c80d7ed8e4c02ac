// When a recorded entry is due, and how late it went.
#pragma once

#include <chrono>
#include <cstdint>

namespace rigsound::log {

/// Deadlines are absolute, from the first entry on: lateness never adds up. Times that run backwards are due
/// at once. Thread: OFF.
class ReplayClock {
 public:
  /// `speed`: 2 plays twice as fast.
  explicit ReplayClock(double speed) : speed_(speed) {}

  void wait_for(std::int64_t time_ns);  ///< returns when the entry of that time is due
  void sent();                          ///< the entry has gone out: notes how late

  std::uint64_t entries() const { return entries_; }
  double mean_late_s() const { return entries_ > 0 ? sum_s_ / static_cast<double>(entries_) : 0; }
  double worst_late_s() const { return worst_s_; }

 private:
  using Steady = std::chrono::steady_clock;
  double speed_;
  bool started_ = false;
  std::int64_t first_ns_ = 0;
  Steady::time_point start_, due_;
  std::uint64_t entries_ = 0;
  double sum_s_ = 0, worst_s_ = 0;
};

}  // namespace rigsound::log
