#include "rigsound/machine/signal.hpp"

#include <cmath>
#include <iterator>

namespace rigsound {
namespace {

template <auto Member>
double get_rig(const MachineState& state, int) {
  return static_cast<double>(state.*Member);
}
template <auto Member>
double get_boom(const MachineState& state, int boom) {
  return static_cast<double>(state.boom[boom].*Member);
}

template <class Value>
void assign(Value& field, double value) {
  field = static_cast<Value>(value);
}
template <auto Member>
void set_rig(MachineState& state, int, double value) {
  assign(state.*Member, value);
}
template <auto Member>
void set_boom(MachineState& state, int boom, double value) {
  assign(state.boom[boom].*Member, value);
}

// A line of the list as SignalInfo; `access`: rig or boom, whose state holds the field.
#define RIGSOUND_INFO(access, State, is_per_boom, member, unit, min, max, absent, idle, action, kind, words, \
                      meaning)                                                                               \
  {#member,                                                                                                  \
   unit,                                                                                                     \
   min,                                                                                                      \
   max,                                                                                                      \
   absent,                                                                                                   \
   idle,                                                                                                     \
   SafetyAction::action,                                                                                     \
   SignalKind::kind,                                                                                         \
   words,                                                                                                    \
   meaning,                                                                                                  \
   is_per_boom,                                                                                              \
   &get_##access<&State::member>,                                                                            \
   &set_##access<&State::member>},
#define RIGSOUND_RIG_INFO(id, member, type, ...) RIGSOUND_INFO(rig, MachineState, false, member, __VA_ARGS__)
#define RIGSOUND_BOOM_INFO(id, member, type, ...) RIGSOUND_INFO(boom, BoomState, true, member, __VA_ARGS__)
#define RIGSOUND_CONTROL_INFO(member, unit, min, max, neutral, kind, meaning) \
  {#member, unit, min, max, neutral, SignalKind::kind, meaning, &DrillControls::member},

bool takes_number(SignalKind kind, double min, double max, double value) noexcept {
  if (kind == SignalKind::kWord && value != std::floor(value)) return false;
  return (value >= min && value <= max) || (kind == SignalKind::kNumberOrZero && value == 0);
}

Range range_of(SignalKind kind, double min, double max, std::string_view unit) noexcept {
  const Range range{min, max, unit.data()};
  return kind == SignalKind::kNumberOrZero                         ? range.or_zero()
         : kind == SignalKind::kWhole || kind == SignalKind::kWord ? range.whole()
                                                                   : range;
}

/// Where the signals of a boom or of the rig that a user holds are marked.
template <class State>
auto& marks_of(State& state, SignalId id) noexcept {
  static_assert(kSignalCount <= 32, "one bit each");
  return info(id.signal).per_boom ? state.boom[id.boom].by_hand : state.by_hand;
}
std::uint32_t mark_of(SignalId id) noexcept { return std::uint32_t{1} << static_cast<int>(id.signal); }

}  // namespace

bool is_by_hand(const MachineState& state, SignalId id) noexcept {
  return (marks_of(state, id) & mark_of(id)) != 0;
}
void mark_by_hand(MachineState& state, SignalId id) noexcept { marks_of(state, id) |= mark_of(id); }

Range SignalInfo::range() const noexcept { return range_of(kind, min, max, unit); }
Range ControlInfo::range() const noexcept { return range_of(kind, min, max, unit); }

bool SignalInfo::takes(double value) const noexcept { return takes_number(kind, min, max, value); }
bool ControlInfo::takes(double value) const noexcept { return takes_number(kind, min, max, value); }

const std::array<SignalInfo, kSignalCount>& signal_table() {
  static constexpr std::array<SignalInfo, kSignalCount> kTable = {
      {RIGSOUND_RIG_SIGNALS(RIGSOUND_RIG_INFO) RIGSOUND_BOOM_SIGNALS(RIGSOUND_BOOM_INFO)}};
  return kTable;
}

const std::array<ControlInfo, 6>& control_table() {
  static constexpr std::array<ControlInfo, 6> kTable = {{RIGSOUND_DRILL_CONTROLS(RIGSOUND_CONTROL_INFO)}};
  return kTable;
}

const SignalInfo& info(Signal s) { return signal_table()[static_cast<std::size_t>(s)]; }

std::optional<Signal> signal_by_name(std::string_view name) {
  const auto& table = signal_table();
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table[i].name == name) return static_cast<Signal>(i);
  return std::nullopt;
}

std::string_view name(Validity v) {
  constexpr std::string_view kNames[] = {"never_seen",  "valid",         "stale",        "bus_down",
                                         "error_value", "not_available", "out_of_range", "manual"};
  static_assert(std::size(kNames) == kValidityCount);
  return kNames[static_cast<std::size_t>(v)];
}

std::optional<double> value_of_word(Signal s, std::string_view word) {
  for (double value = 0; !value_word(s, value).empty(); ++value)
    if (value_word(s, value) == word) return value;
  return std::nullopt;
}

std::string_view value_word(Signal s, double value) {
  std::string_view words = info(s).words;
  for (int skip = value >= 0 ? static_cast<int>(value) : -1; !words.empty(); --skip) {
    const std::size_t end = words.find('|');
    if (skip == 0) return words.substr(0, end);
    words.remove_prefix(end == std::string_view::npos ? words.size() : end + 1);
  }
  return {};
}

}  // namespace rigsound
