// How the audio thread is doing, readable from anywhere.
#pragma once

#include <atomic>
#include <cstdint>

namespace rigsound::daemon {

/// Written by the audio thread only. Each figure stands for itself and is relaxed, but for those of the time
/// a block takes: who reads busy_ns first, with acquire, finds every block of it in the other two.
struct AudioFigures {
  std::atomic<std::uint64_t> blocks{0};      ///< since the daemon started
  std::atomic<std::uint64_t> run_blocks{0};  ///< of the run; released after the records of these blocks
  std::atomic<std::uint32_t> run{0};
  std::atomic<std::uint64_t> busy_ns{0};   ///< spent in the engine, all blocks together; released
  std::atomic<std::uint64_t> measured{0};  ///< blocks that have been computed, and perhaps not yet played
  std::atomic<std::uint64_t> worst_ns{0};  ///< of one block
  std::atomic<std::uint64_t> deadline_misses{0};  ///< blocks that took longer to compute than to play
  std::atomic<std::uint64_t> clock_jumps{0};      ///< times no block was rendered for over a second
  std::atomic<std::uint64_t> skipped_blocks{0};   ///< that should have been, then
  std::atomic<std::uint64_t> lost_records{0};
  std::atomic<std::uint64_t> lost_clicks{0}, dropped_chunks{0};  ///< of the run, as in EngineMeters
  std::atomic<float> peak{0};                                    ///< of the last block, linear
};

}  // namespace rigsound::daemon
