#include "state_exchange.hpp"

#include "monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

using Lock = std::lock_guard<std::mutex>;

void copy_readings(const SignalBoard& from, SignalBoard& to, double now_s) {
  for (int s = 0; s < kSignalCount; ++s)
    for (std::uint8_t boom = 0; boom < kMaxBooms; ++boom) {
      const SignalId id{static_cast<Signal>(s), boom};
      const SignalBoard::Reading r = from.reading(id, now_s);
      if (r.validity == Validity::kNeverSeen) continue;
      to.update(id, r.value, r.seen_s);
      if (r.validity != Validity::kValid && r.validity != Validity::kStale) to.invalidate(id, r.validity);
    }
}

}  // namespace

StateExchange::StateExchange(const SafetyOptions& safety)
    : board_(safety), handoff_(board_.resolve(monotonic_s())) {}

// Under the lock there is only ever one writer, as the handoff wants it.
void StateExchange::publish() {
  const double now_s = monotonic_s();
  MachineState state = board_.resolve(now_s);
  state.safety_gain *= static_cast<float>(mute_.gain(now_s) * gate_.gain(now_s));
  for (std::size_t b = 0; b < controls_.size(); ++b) state.boom[b].controls = controls_[b];
  output_gain_ = state.safety_gain;
  handoff_.write(state);
}

void StateExchange::change(const std::function<void(SignalBoard&)>& edit) {
  const Lock lock(mutex_);
  edit(board_);
  publish();
}

void StateExchange::tick() {
  const Lock lock(mutex_);
  publish();
}

void StateExchange::set_controls(int boom, const DrillControls& controls) {
  const Lock lock(mutex_);
  controls_[static_cast<std::size_t>(boom)] = controls;
  publish();
}

DrillControls StateExchange::controls(int boom) const {
  const Lock lock(mutex_);
  return controls_[static_cast<std::size_t>(boom)];
}

void StateExchange::set_muted(bool muted, double fade_s) {
  const Lock lock(mutex_);
  muted_ = muted;
  mute_.start(muted ? 0 : 1, fade_s, monotonic_s());
  publish();
}

bool StateExchange::muted() const {
  const Lock lock(mutex_);
  return muted_;
}

void StateExchange::set_gate(double target, double fade_s) {
  const Lock lock(mutex_);
  gate_.start(target, fade_s, monotonic_s());
  publish();
}

void StateExchange::set_safety(const SafetyOptions& safety) {
  const Lock lock(mutex_);
  SignalBoard board(safety);
  copy_readings(board_, board, monotonic_s());
  board_ = board;
  publish();
}

SignalBoard::Reading StateExchange::reading(SignalId id) const {
  const Lock lock(mutex_);
  return board_.reading(id, monotonic_s());
}

double StateExchange::resolved(SignalId id) const {
  const Lock lock(mutex_);
  return board_.resolved(id);
}

float StateExchange::output_gain() const {
  const Lock lock(mutex_);
  return output_gain_;
}

}  // namespace rigsound::daemon
