// The safety rules that turn readings into the state the engine is given.
#pragma once

#include <array>

#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound {

/// Deterministic: the result depends on the readings and the times passed in, never on a clock; live and
/// offline resolve alike. Never allocates, locks or throws. Thread: one at a time, RT included.
class StateResolver {
 public:
  /// The state to tell the engine from `now_s` on. Times must not run backwards.
  MachineState resolve(const SignalBoard& board, const SafetyOptions& safety, double now_s) noexcept;

  /// Whether resolve() at `now_s` could give another state though no reading came: a fade is under way, or a
  /// signal has grown stale.
  bool due(double now_s) const noexcept { return now_s >= next_change_s_; }

  /// Whether the last resolve() found every signal as its bus says: no safety rule stood in for one, in part
  /// or whole, and no user held one.
  bool as_told() const noexcept { return as_told_; }

  /// What stands for a signal after the safety rule, as resolve() last set it and as the bus said it: the
  /// speed of the state is tracked between messages, this one is not.
  double value(SignalId id) const noexcept { return value_[static_cast<std::size_t>(id.signal)][id.boom]; }

 private:
  struct Standing {
    double value, fallback_mix;
  };
  Standing resolve_signal(SignalId id, const SignalBoard& board, const SafetyOptions& safety,
                          double now_s) noexcept;
  void expect_change(double time_s) noexcept;
  void fade(double& mix, double target) noexcept;

  /// 0: the reading stands, 1: the safety rule does; moves over the fade time.
  std::array<std::array<double, kMaxBooms>, kSignalCount> fallback_mix_{}, value_{};
  double safety_gain_ = 1;
  double last_s_ = 0, next_change_s_ = 0;
  double step_ = 0;  ///< share of a fade that passed since the last resolve()
  bool fading_ = false, muted_ = false, as_told_ = false;
};

}  // namespace rigsound
