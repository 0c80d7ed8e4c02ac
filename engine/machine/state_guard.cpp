#include "rigsound/machine/state_guard.hpp"

#include "rigsound/machine/signal.hpp"

namespace rigsound {
namespace {

float within(float x, float low, float high, float otherwise) noexcept {
  if (!(x == x)) return otherwise;
  return x < low ? low : x > high ? high : x;
}

/// A number is brought into its range; an enumeration that is none of its values means quiet.
double guarded(const SignalInfo& signal, double value) noexcept {
  if (!(value == value)) return signal.absent;
  if (value == signal.absent || signal.takes(value)) return value;
  if (signal.kind == SignalKind::kWord) return signal.idle;
  // Below a marker for "absent" that lies under the range (a load of -1) is nothing but absent.
  if (signal.absent < signal.min && value < signal.min) return signal.absent;
  return value < signal.min ? signal.min : signal.max;
}

float guarded(const ControlInfo& control, float value) noexcept {
  const auto neutral = static_cast<float>(control.neutral);
  if (control.kind == SignalKind::kNumberOrZero && !(value > 0)) return neutral;
  return within(value, static_cast<float>(control.min), static_cast<float>(control.max), neutral);
}

}  // namespace

MachineState guarded(const MachineState& state) noexcept {
  MachineState safe = state;
  for_each_signal(kMaxBooms, [&](SignalId id) {
    const SignalInfo& signal = info(id.signal);
    signal.set(safe, id.boom, guarded(signal, signal.get(state, id.boom)));
  });
  safe.engine_rpm_slope = within(state.engine_rpm_slope, -kMaxSpeedSlope, kMaxSpeedSlope, 0);
  safe.output_gain = within(state.output_gain, 0, 1, 0);
  for (BoomState& boom : safe.boom)
    for (const ControlInfo& control : control_table())
      boom.controls.*control.field = guarded(control, boom.controls.*control.field);
  return safe;
}

}  // namespace rigsound
