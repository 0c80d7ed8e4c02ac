// What leaves the audio thread for the recorder.
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <cstdint>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::daemon {

/// A run is what one engine rendered from its block 0 on.
struct RunRecord {
  enum class Kind : std::uint8_t { kChange, kEnd };
  Kind kind = Kind::kChange;
  std::uint32_t run = 0;    ///< counts engines
  std::uint64_t block = 0;  ///< kChange: `state` acts from it on; kEnd: it was not rendered any more
  MachineState state;
  std::uint64_t lost = 0;  ///< records dropped so far, in all runs
};

/// Bounded: the audio thread drops records (and counts) rather than wait.
using RunQueue = moodycamel::ReaderWriterQueue<RunRecord>;
constexpr std::size_t kRunQueueLength = 8192;

}  // namespace rigsound::daemon
