#include "rigsound/log/replay_clock.hpp"

#include <algorithm>
#include <thread>

namespace rigsound::log {

void ReplayClock::wait_for(std::int64_t time_ns) {
  if (!started_) {
    started_ = true;
    first_ns_ = time_ns;
    start_ = due_ = Steady::now();
  }
  const double after_s = static_cast<double>(time_ns - first_ns_) * 1e-9 / speed_;
  due_ = std::max(
      due_, start_ + std::chrono::duration_cast<Steady::duration>(std::chrono::duration<double>(after_s)));
  std::this_thread::sleep_until(due_);
}

void ReplayClock::sent() {
  const double late_s = std::chrono::duration<double>(Steady::now() - due_).count();
  ++entries_;
  sum_s_ += late_s;
  worst_s_ = std::max(worst_s_, late_s);
}

}  // namespace rigsound::log
