// An end that reaches whoever waits.
#pragma once

#include <poll.h>

#include <atomic>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound {

/// Set once, for ever.
class StopEvent {
 public:
  StopEvent();  ///< Errors: DeviceError when the process has no descriptor left. Thread: CT

  void set() noexcept;                                                           ///< Thread: any
  bool is_set() const noexcept { return set_.load(std::memory_order_acquire); }  ///< Thread: any

  /// Until `fd` has one of `events` or is broken: true; until the time is up, a signal comes or the event is
  /// set: false. `fd` -1: waits for the event only. Thread: any
  bool wait(int fd, short events, int timeout_ms) const noexcept;

  /// For a poll() of several: readable once set.
  pollfd to_poll() const noexcept { return {fd_.get(), POLLIN, 0}; }

 private:
  FileDescriptor fd_;
  std::atomic<bool> set_{false};
};

}  // namespace rigsound
