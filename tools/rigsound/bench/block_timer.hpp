// What an engine costs, block by block.
#pragma once

#include <optional>

#include "rigsound/engine.hpp"

namespace rigsound::tools {

struct EngineCost {
  double ns_a_sample = 0;                       ///< mean
  std::optional<double> instructions_a_sample;  ///< mean; nothing where they cannot be counted
  double mean_block_us = 0, worst_block_us = 0;
  long blocks = 0, over_deadline = 0;  ///< blocks that took longer than they last
};

/// Plays `seconds` of sound of `state` after a second of warm-up, as fast as it goes. Thread: OFF.
EngineCost measure(const EngineOptions& options, const SoundSet& sounds, const MachineState& state,
                   double seconds);

}  // namespace rigsound::tools
