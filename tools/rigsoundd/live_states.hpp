// The state of a live block: the newest readings under the safety rules, live controls and output fades.
#pragma once

#include "rigsound/machine/state_resolver.hpp"
#include "state_exchange.hpp"

namespace rigsound::daemon {

/// Resolves when something was said, a fade is under way or a signal has grown stale; between that the state
/// stands and the engine extrapolates. Thread: RT.
class LiveStates {
 public:
  explicit LiveStates(TripleBuffer<StateInput>& handoff) noexcept : handoff_(handoff) {}

  /// The state from `now_s` (monotonic_s()) on. Valid until the next call.
  const MachineState& at(double now_s) noexcept;

 private:
  TripleBuffer<StateInput>& handoff_;
  StateResolver resolver_;
  MachineState state_;
  std::uint64_t revision_ = 0;
  bool fading_ = true;  // the first state is due
};

}  // namespace rigsound::daemon
