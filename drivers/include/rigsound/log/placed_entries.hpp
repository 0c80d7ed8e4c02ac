// The entries of a capture one by one, each at its place in the log's time: the clock looks one entry ahead.
#pragma once

#include <optional>
#include <utility>

#include "rigsound/log/log_clock.hpp"

namespace rigsound::log {

/// `Capture`: has bool next(Entry&); `Entry`: has time_ns. Thread: OFF.
template <class Capture, class Entry>
class PlacedEntries {
 public:
  explicit PlacedEntries(std::optional<double> longest_gap_s) : clock_(longest_gap_s) {}

  /// The entry whose turn it is; null at the end. Errors: what the capture throws.
  const Entry* front(Capture& capture) {
    if (front_) return &*front_;
    if (!started_) read_ahead(capture);
    started_ = true;
    if (!ahead_) return nullptr;
    front_ = std::move(ahead_);
    read_ahead(capture);
    const auto next_ns = ahead_ ? std::optional<std::int64_t>(ahead_->time_ns) : std::nullopt;
    time_ns_ = clock_.place(front_->time_ns, next_ns, 0);
    return &*front_;
  }
  void pop() { front_.reset(); }

  std::int64_t time_ns() const { return time_ns_; }  ///< of the front or the last one, since the first entry
  double time_s() const { return static_cast<double>(time_ns_) * 1e-9; }
  const LogClock& clock() const { return clock_; }

 private:
  void read_ahead(Capture& capture) {
    Entry next;
    ahead_ = capture.next(next) ? std::optional<Entry>(std::move(next)) : std::nullopt;
  }

  LogClock clock_;
  std::optional<Entry> front_, ahead_;
  std::int64_t time_ns_ = 0;
  bool started_ = false;
};

}  // namespace rigsound::log
