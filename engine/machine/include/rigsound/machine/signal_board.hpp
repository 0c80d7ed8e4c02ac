// The latest reading of every signal, and the safety rule that turns readings into a MachineState.
#pragma once

#include <array>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound {

/// What happens when a signal is no longer valid: keep its last good value, go to the value that means
/// quiet, or fade the whole rig out.
enum class SafetyAction : std::uint8_t { kHold, kIdle, kMute };

struct SafetyRule {
  double stale_after_s = 0;  ///< age at which the signal goes stale; 0: never
  SafetyAction action = SafetyAction::kHold;
};

struct SafetyOptions {
  std::array<SafetyRule, kSignalCount> rule{};
  double fade_s = 0.3;    ///< time a safety action takes to act, and to let go
  double idle_rpm = 800;  ///< where `idle` brings the diesel, r/min; one that turned slower stays there
};

/// Collects readings from buses and resolves them at block boundaries. Deterministic: the result depends
/// on the readings and the times passed in, never on a clock. Thread: CT (one thread at a time).
class SignalBoard {
 public:
  explicit SignalBoard(const SafetyOptions& options);

  /// A value as decoded from a bus, in the signal's unit. NaN or a value outside the signal's range is
  /// recorded as invalid (kOutOfRange) and the last good value stays; the value that means "absent" may be
  /// said too. Returns the validity recorded.
  Validity update(SignalId id, double value, double time_s);

  /// The bus said something that is no value (error code, not available), or is down. A signal that was
  /// never seen stays so; a later update() heals any other.
  void invalidate(SignalId id, Validity why);

  struct Reading {
    double value = 0;   ///< last good value
    double seen_s = 0;  ///< when it was last good
    Validity validity = Validity::kNeverSeen;
  };
  /// The reading as of `now_s`: a valid one older than its rule allows is kStale.
  Reading reading(SignalId id, double now_s) const;

  /// The state the engine shall be told from `now_s` on. Times must not run backwards.
  MachineState resolve(double now_s);

  /// The engineering value now standing for a signal after the safety rule, as resolve() last set it.
  double resolved(SignalId id) const;

 private:
  struct Cell {
    Reading reading;
    double shown = 0;     ///< resolved value
    double distrust = 0;  ///< 0: the reading stands, 1: the safety rule does; moves over fade_s
  };
  const Cell& cell(SignalId id) const;
  Cell& cell(SignalId id);
  double rest_value(Signal s, double last_good) const;
  Reading reading_of(const Cell& c, Signal s, double now_s) const;
  void settle(Signal s, Cell& c, double now_s, double step, bool& mute);

  SafetyOptions options_;
  std::array<std::array<Cell, kMaxBooms>, kSignalCount> cells_;
  double safety_gain_ = 1;
  double last_s_ = 0;
  bool started_ = false;
};

}  // namespace rigsound
