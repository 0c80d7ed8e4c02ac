// What leaves the audio thread for the recorder.
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstdint>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::daemon {

/// A run is what one engine rendered from its block 0 on.
struct RunRecord {
  enum class Kind : std::uint8_t { kChange, kSkip, kEnd };
  Kind kind = Kind::kChange;
  std::uint32_t run = 0;  ///< counts engines
  std::uint64_t block =
      0;  ///< kChange: `state` acts from it on; kSkip: before it; kEnd: not rendered any more
  MachineState state;
  std::uint64_t lost = 0;     ///< records dropped so far, in all runs
  std::uint64_t skipped = 0;  ///< kSkip: blocks that time went by for
};

/// Bounded: the audio thread drops records (and counts) rather than wait.
using RunQueue = moodycamel::ReaderWriterQueue<RunRecord>;
constexpr std::size_t kRunQueueLength = 8192;

/// The audio thread's end of the queue. Thread: RT
class RunReporter {
 public:
  /// `lost` counts the records that found the queue full.
  RunReporter(RunQueue& records, std::atomic<std::uint64_t>& lost) : records_(records), lost_(lost) {}

  /// `state` acts from `block` of `run` on. Makes a record, and returns true, for the first state of a run
  /// and for one with a field that differs from the last.
  bool report(std::uint32_t run, std::uint64_t block, const MachineState& state) noexcept {
    if (block != 0 && state == last_) return false;
    last_ = state;
    enqueue({RunRecord::Kind::kChange, run, block, state, 0, 0});
    return true;
  }
  void report_skip(std::uint32_t run, std::uint64_t block, std::uint64_t skipped) noexcept {
    enqueue({RunRecord::Kind::kSkip, run, block, {}, 0, skipped});
  }
  void report_end(std::uint32_t run, std::uint64_t block) noexcept {
    enqueue({RunRecord::Kind::kEnd, run, block, {}, 0, 0});
  }

 private:
  void enqueue(RunRecord record) noexcept {
    record.lost = lost_.load(std::memory_order_relaxed);
    if (!records_.try_enqueue(record)) lost_.store(record.lost + 1, std::memory_order_relaxed);
  }

  RunQueue& records_;
  std::atomic<std::uint64_t>& lost_;
  MachineState last_;
};

}  // namespace rigsound::daemon
