// What each block of an engine costs when nothing comes between.
#pragma once

#include <optional>
#include <vector>

#include "rigsound/audio/block_loop.hpp"

namespace rigsound::tools {

/// Of runs that play the same states: whatever makes a block dearer in one of them was not the engine.
struct BlockCosts {
  std::vector<double> least_us;                ///< of each block, over the runs: processor time of the thread
  std::vector<double> mean_us;                 ///< of a block, one a run
  std::optional<double> instructions_a_block;  ///< of the run with the fewest; none where nobody counts them
  double processor_s = 0, wall_s = 0;          ///< of all runs: they differ by what others took
};

/// Plays `states` from block 0 to their end and counts from block `settling` on. Thread: OFF.
void add_run(BlockCosts& costs, Engine engine, audio::StateSource& states, std::uint64_t settling);

}  // namespace rigsound::tools
