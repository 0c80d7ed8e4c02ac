// One recording among those of the simulated machine.
#pragma once

#include <cstdint>

#include "simulate/split_mix.hpp"

namespace rigsound::analysis {

/// Gives every purpose of every recording a stream of chance of its own.
struct Take {
  std::uint64_t seed = 1, number = 0;

  SplitMix stream(std::uint64_t purpose) const {
    return SplitMix(dsp::mix64(seed) + dsp::mix64(8 * number + purpose + 1));
  }
};

constexpr std::uint64_t kMachine = 77001;  ///< seeds of what belongs to the machine, not to a recording

}  // namespace rigsound::analysis
