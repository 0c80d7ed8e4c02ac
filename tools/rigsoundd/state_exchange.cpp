#include "state_exchange.hpp"

#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

using Lock = std::lock_guard<std::mutex>;

StateInput first_input(const SafetyOptions& safety) {
  StateInput input;
  input.safety = safety;
  return input;
}

}  // namespace

StateExchange::StateExchange(const SafetyOptions& safety) : input_(first_input(safety)), handoff_(input_) {}

// Under the lock there is only ever one writer, as the handoff wants it.
template <typename Edit>
void StateExchange::edit(Edit edit) {
  const Lock lock(mutex_);
  edit(input_);
  ++input_.revision;
  handoff_.write(input_);
}

void StateExchange::change(const std::function<void(SignalBoard&)>& change) {
  edit([&](StateInput& input) { change(input.board); });
}

void StateExchange::set_control(int boom, const ControlInfo& control, double value) {
  edit([&](StateInput& input) { input.controls[boom].*control.field = static_cast<float>(value); });
}

DrillControls StateExchange::controls(int boom) const {
  const Lock lock(mutex_);
  return input_.controls[boom];
}

void StateExchange::set_muted(bool muted, double fade_s) {
  edit([&](StateInput& input) {
    muted_ = muted;
    input.mute.start(muted ? 0 : 1, fade_s, monotonic_s());
  });
}

bool StateExchange::muted() const {
  const Lock lock(mutex_);
  return muted_;
}

void StateExchange::set_gate(double target, double fade_s) {
  edit([&](StateInput& input) { input.gate.start(target, fade_s, monotonic_s()); });
}

void StateExchange::set_exposure_gain(double gain, double fade_s) {
  edit([&](StateInput& input) { input.exposure.start(gain, fade_s, monotonic_s()); });
}

void StateExchange::set_safety(const SafetyOptions& safety) {
  edit([&](StateInput& input) { input.safety = safety; });
}

SignalBoard StateExchange::board() const {
  const Lock lock(mutex_);
  return input_.board;
}

SafetyOptions StateExchange::safety() const {
  const Lock lock(mutex_);
  return input_.safety;
}

}  // namespace rigsound::daemon
