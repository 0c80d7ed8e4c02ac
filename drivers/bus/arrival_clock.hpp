// When the kernel got a message, on the clock that readings count in.
#pragma once

#include <algorithm>
#include <chrono>

#include "rigsound/monotonic_time.hpp"

namespace rigsound {

/// The kernel stamps with the time of day; readings count from the machine's start. Made once for a batch of
/// messages. Thread: any.
class ArrivalClock {
 public:
  ArrivalClock()
      : realtime_s_(
            std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count()),
        now_s_(rigsound::monotonic_s()) {}

  /// `realtime_s`: the kernel's stamp; 0: it gave none. An age outside 0...1 s is clamped.
  double monotonic_s(double realtime_s) const {
    const double age_s = realtime_s > 0 ? realtime_s_ - realtime_s : 0;
    return now_s_ - std::clamp(age_s, 0.0, 1.0);
  }

 private:
  double realtime_s_, now_s_;  // the same moment on both clocks
};

}  // namespace rigsound
