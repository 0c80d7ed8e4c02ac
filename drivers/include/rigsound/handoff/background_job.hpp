// Work that may take as long as it likes, or never end.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "rigsound/bus/stop_event.hpp"

namespace rigsound {

/// One job at a time, on a thread of its own that nobody waits for: destruction abandons it, and its outcome
/// is destroyed there. Thread: CT.
template <class Outcome>
class BackgroundJob {
 public:
  /// `work` must not throw, nor use what others may change or destroy meanwhile. Not while busy.
  void begin(std::function<Outcome()> work) {
    job_ = std::make_shared<Job>();
    job_->work = std::move(work);
    std::thread([job = job_] {
      job->outcome = std::exchange(job->work, nullptr)();
      job->done.set();
    }).detach();
  }

  bool busy() const { return job_ != nullptr; }

  std::optional<Outcome> take() {  ///< once it is there
    if (!job_ || !job_->done.is_set()) return std::nullopt;
    Outcome outcome = std::move(job_->outcome);
    job_.reset();
    return outcome;
  }

  /// Readable when there is something to take.
  pollfd to_poll() const { return job_ ? job_->done.to_poll() : pollfd{-1, 0, 0}; }

  /// Until there is, at most so long.
  void wait(int timeout_ms) const {
    if (job_) job_->done.wait(-1, 0, timeout_ms);
  }

 private:
  struct Job {
    std::function<Outcome()> work;
    Outcome outcome;
    StopEvent done;
  };
  std::shared_ptr<Job> job_;
};

}  // namespace rigsound
