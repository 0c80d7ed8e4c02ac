// The machine's state as the engine is given it with every block. Plain data, field units, no pointers.
#pragma once

#include <array>
#include <cstdint>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/signal_list.hpp"

namespace rigsound {

enum class Rattling : std::uint8_t { kNone, kClosed, kOpen };

/// `kFromFeed`: no bus says; on while the feed pressure is over the contact threshold, or while rattling.
enum class Percussion : std::uint8_t { kOff, kOn, kFromFeed };

enum class RodBroken : std::uint8_t { kNo, kYes };

enum class Simulation : std::uint8_t { kRun, kFreeze, kReset };

#define RIGSOUND_MEMBER(id, member, type, unit, min, max, absent, ...) \
  type member = static_cast<type>(absent);
#define RIGSOUND_CONTROL_MEMBER(member, unit, min, max, neutral, ...) float member = neutral;

/// Units, ranges and meanings: signal_list.hpp. All neutral by default.
struct DrillControls {
  RIGSOUND_DRILL_CONTROLS(RIGSOUND_CONTROL_MEMBER)
};

struct BoomState {
  RIGSOUND_BOOM_SIGNALS(RIGSOUND_MEMBER)
  DrillControls controls;
  std::uint32_t by_hand = 0;  ///< signals that a user holds, bit by Signal; for the record, nobody hears it
};

/// A signal that was never seen has the value that means "absent".
struct MachineState {
  RIGSOUND_RIG_SIGNALS(RIGSOUND_MEMBER)
  float engine_rpm_slope = 0;  ///< r/min a second: how engine_rpm goes on until the next state
  float output_gain = 1;       ///< 0...1: safety rule `mute`, the user's mute and the daemon's fades together
  std::uint32_t by_hand = 0;   ///< as BoomState's, of the signals of the rig
  std::array<BoomState, kMaxBooms> boom{};
};

#undef RIGSOUND_MEMBER
#undef RIGSOUND_CONTROL_MEMBER

/// Calls `visit` with every field in the order of the list: rig signals, slope, gain, by hand, then boom by
/// boom its signals, its controls, by hand. `State`: MachineState, const or not.
template <class State, class Visit>
void for_each_field(State& state, Visit visit) {
#define RIGSOUND_VISIT_RIG(id, member, ...) visit(state.member);
#define RIGSOUND_VISIT_BOOM(id, member, ...) visit(boom.member);
#define RIGSOUND_VISIT_CONTROL(member, ...) visit(boom.controls.member);
  RIGSOUND_RIG_SIGNALS(RIGSOUND_VISIT_RIG)
  visit(state.engine_rpm_slope);
  visit(state.output_gain);
  visit(state.by_hand);
  for (auto& boom : state.boom) {
    RIGSOUND_BOOM_SIGNALS(RIGSOUND_VISIT_BOOM)
    RIGSOUND_DRILL_CONTROLS(RIGSOUND_VISIT_CONTROL)
    visit(boom.by_hand);
  }
#undef RIGSOUND_VISIT_RIG
#undef RIGSOUND_VISIT_BOOM
#undef RIGSOUND_VISIT_CONTROL
}

/// Field by field: padding does not count. Thread: any.
bool operator==(const MachineState& a, const MachineState& b) noexcept;
inline bool operator!=(const MachineState& a, const MachineState& b) noexcept { return !(a == b); }

}  // namespace rigsound
