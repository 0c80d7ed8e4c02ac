// The machine's signals by name, unit and range, as buses deliver them one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/safety.hpp"
#include "rigsound/machine/signal_list.hpp"

namespace rigsound {

#define RIGSOUND_ID(id, ...) id,
enum class Signal : std::uint8_t { RIGSOUND_RIG_SIGNALS(RIGSOUND_ID) RIGSOUND_BOOM_SIGNALS(RIGSOUND_ID) };
#undef RIGSOUND_ID

enum class SignalKind : std::uint8_t {
  kNumber,         ///< fades
  kClampedNumber,  ///< the same; up to twice its range it is brought to its upper end, and counted
  kNumberOrZero,   ///< the same; 0 says that no value is given
  kWhole,          ///< whole numbers, never fades
  kWord,           ///< one of the list's words, never fades
};

struct SignalInfo {
  std::string_view name;  ///< key in rig files and in the CSV of `rigsound decode`
  std::string_view unit;
  double min, max;  ///< a value outside is refused
  double absent;    ///< the value that stands when the signal was never seen; no bus can deliver it
  double idle;      ///< the value that means quiet (safety rule `idle`)
  SafetyAction action;
  SignalKind kind;
  std::string_view words;  ///< of the values 0, 1, ..., separated by '|'
  std::string_view meaning;
  bool per_boom;  ///< drilling signals exist once per boom, diesel signals once per rig
  double (*get)(const MachineState& state, int boom);
  void (*set)(MachineState& state, int boom, double value);

  bool stepped() const noexcept { return kind == SignalKind::kWhole || kind == SignalKind::kWord; }
  bool takes(double value) const noexcept;  ///< whether a bus may say `value`; NaN never. Thread: any
  Range range() const noexcept;             ///< of what a user may set. Thread: any
};

/// In the list's order: one entry per Signal. Thread: any.
const std::array<SignalInfo, kSignalCount>& signal_table();
const SignalInfo& info(Signal s);
std::optional<Signal> signal_by_name(std::string_view name);

/// The value of a word; nothing when it is none of the signal's. Thread: any
std::optional<double> value_of_word(Signal s, std::string_view word);

/// The word for a value of a signal that has words ("closed", "on"), or empty when the value is a plain
/// number.
std::string_view value_word(Signal s, double value);

/// Which signal of which boom; boom is 0 for signals of the whole rig.
struct SignalId {
  Signal signal{};
  std::uint8_t boom = 0;
};

/// Whether a user holds the signal in this state.
bool is_by_hand(const MachineState& state, SignalId id) noexcept;
void mark_by_hand(MachineState& state, SignalId id) noexcept;

/// Calls `visit(SignalId)` for every signal of a rig with `booms` booms: rig signals, then boom by boom.
template <class Visit>
void for_each_signal(int booms, Visit visit) {
  for (int s = 0; s < kSignalCount; ++s)
    if (!signal_table()[s].per_boom) visit(SignalId{static_cast<Signal>(s), 0});
  for (int b = 0; b < booms; ++b)
    for (int s = 0; s < kSignalCount; ++s)
      if (signal_table()[s].per_boom) visit(SignalId{static_cast<Signal>(s), static_cast<std::uint8_t>(b)});
}

/// The six live controls by name and range.
struct ControlInfo {
  std::string_view name, unit;
  double min, max, neutral;
  SignalKind kind;
  std::string_view meaning;
  float DrillControls::*field;

  bool takes(double value) const noexcept;  ///< Thread: any
  Range range() const noexcept;             ///< Thread: any
};
const std::array<ControlInfo, 6>& control_table();

}  // namespace rigsound
