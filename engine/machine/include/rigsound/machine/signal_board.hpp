// The latest reading of every signal.
#pragma once

#include <array>
#include <limits>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/reading.hpp"
#include "rigsound/machine/rpm_tracker.hpp"

namespace rigsound {

/// Collects readings from buses. Deterministic: it depends on the readings and the times in them, never on a
/// clock. Plain data that may be copied to another thread. Thread: one at a time.
class SignalBoard {
 public:
  static constexpr double kNever_s = -std::numeric_limits<double>::infinity();

  /// A value outside the signal's range, NaN, or one that is no value of a word is recorded as kOutOfRange
  /// and counted; the last good value stays. What is no value (error code, not available) likewise, also of a
  /// signal that was never good: then the value for "absent" stands and the safety rule acts. A bus that is
  /// down, or up again without a value yet (kStale), leaves a signal that was never seen as it is. A later
  /// good one heals any. Returns the validity recorded.
  Validity take(const Reading& reading) noexcept;

  /// From now on `value`, which the signal must take, stands whatever buses say; their readings are taken
  /// all the same and stand once it is released.
  void hold(SignalId id, double value) noexcept;
  void release(SignalId id) noexcept;

  struct Entry {
    double value = 0;          ///< last good value
    double seen_s = kNever_s;  ///< when it was last good
    Validity validity = Validity::kNeverSeen;
    std::uint32_t refused = 0;                     ///< readings that were no value or out of range
    std::uint32_t clamped = 0;                     ///< readings over the range that were brought to its end
    double last_refused = 0;                       ///< the last value out of range
    Validity last_refusal = Validity::kNeverSeen;  ///< why the last one was refused; kNeverSeen: none was
    bool by_hand = false;                          ///< a user holds the signal at
    double hand_value = 0;                         ///< this value

    bool ever_good() const noexcept { return seen_s > kNever_s; }
  };
  const Entry& entry(SignalId id) const noexcept;

  /// The entry's validity as of `now_s`: a valid one older than the rule allows is kStale, one that a user
  /// holds is kManual.
  Validity validity(SignalId id, const SafetyRule& rule, double now_s) const noexcept;

  const RpmTracker& speed() const noexcept { return speed_; }

 private:
  std::array<std::array<Entry, kMaxBooms>, kSignalCount> entries_{};
  RpmTracker speed_;
};

}  // namespace rigsound
