#include "live_states.hpp"

namespace rigsound::daemon {

const MachineState& LiveStates::at(double now_s) noexcept {
  const StateInput& input = handoff_.read();
  if (input.revision == revision_ && !fading_ && !resolver_.due(now_s)) return state_;
  revision_ = input.revision;
  fading_ = input.mute.moving(now_s) || input.gate.moving(now_s) || input.exposure.moving(now_s);
  state_ = resolver_.resolve(input.board, input.safety, now_s);
  state_.output_gain *=
      static_cast<float>(input.mute.gain(now_s) * input.gate.gain(now_s) * input.exposure.gain(now_s));
  for (int b = 0; b < kMaxBooms; ++b) state_.boom[b].controls = input.controls[b];
  return state_;
}

}  // namespace rigsound::daemon
