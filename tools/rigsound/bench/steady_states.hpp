// A machine that does one thing for so many blocks.
#pragma once

#include "rigsound/audio/block_loop.hpp"

namespace rigsound::tools {

class SteadyStates : public audio::StateSource {
 public:
  SteadyStates(const MachineState& state, std::uint64_t blocks) : state_(state), blocks_(blocks) {}
  const MachineState* state_of(std::uint64_t number) override { return number < blocks_ ? &state_ : nullptr; }

 private:
  MachineState state_;
  std::uint64_t blocks_;
};

}  // namespace rigsound::tools
