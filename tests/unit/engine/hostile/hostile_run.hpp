// Engines against hostile input, and what came of it.
#pragma once

#include <cstdint>

#include "engine/hostile/hostile_input.hpp"

namespace rigsound::tests {

struct HostileFindings {
  std::int64_t blocks = 0, engines = 0;
  std::int64_t not_finite = 0, over_ceiling = 0;  ///< samples
  double highest_true_peak = 0;                   ///< against the ceiling, of engines that look ahead
  std::int64_t allocations = 0;                   ///< inside process()
  std::int64_t dropped_chunks = 0;
  std::int64_t not_healed = 0;  ///< engines that dropped a chunk, or were silent, once input was sane again
};

/// One engine with sounds of its own plays `blocks` hostile blocks, each state for one block or held; then
/// sane ones, which must sound, with nothing dropped, from 50 ms on.
void run_hostile(HostileInput& input, std::int64_t blocks, HostileFindings& findings);

}  // namespace rigsound::tests
