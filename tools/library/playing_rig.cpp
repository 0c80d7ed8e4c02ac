#include "playing_rig.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::library {
namespace {

/// The entry of a table of signals or controls that bears the name.
template <class Table>
const auto& entry_named(const Table& table, std::string_view name, const std::string& kind) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string> known;
  for (const auto& entry : table) known.emplace_back(entry.name);
  const std::string_view near = config::nearest_word(name, known);
  throw std::invalid_argument("'" + std::string(name) + "' is no " + kind +
                              (near.empty() ? std::string() : ", did you mean '" + std::string(near) + "'?"));
}

template <class Info>
void require_taken(const Info& info, double value) {
  if (!info.takes(value))
    throw std::invalid_argument(std::string(info.name) + ": " + info.range().problem(value));
}

}  // namespace

PlayingRig::PlayingRig(Engine engine) : engine_(std::move(engine)), handoff_(MachineState{}) {}

void PlayingRig::require_boom(int boom) const {
  const auto booms = static_cast<int>(options().booms.size());
  if (boom < 0 || boom >= booms)
    throw std::invalid_argument("boom: is " + std::to_string(boom) + ", expected 0..." +
                                std::to_string(booms - 1));
}

void PlayingRig::set_signal(std::string_view name, int boom, double value) {
  const SignalInfo& signal = entry_named(signal_table(), name, "signal");
  require_boom(boom);
  if (value != signal.absent) require_taken(signal, value);
  const std::lock_guard<std::mutex> lock(mutex_);
  signal.set(state_, boom, value);
  handoff_.write(state_);
}

void PlayingRig::set_control(std::string_view name, int boom, double value) {
  const ControlInfo& control = entry_named(control_table(), name, "control");
  require_boom(boom);
  require_taken(control, value);
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.boom[boom].controls.*control.field = static_cast<float>(value);
  handoff_.write(state_);
}

void PlayingRig::process(float* out) noexcept {
  engine_.process(handoff_.read(), out);
  const EngineMeters meters = engine_.meters();
  peak_.store(meters.peak, std::memory_order_relaxed);
  rms_.store(meters.rms, std::memory_order_relaxed);
  limiter_gain_.store(meters.limiter_gain, std::memory_order_relaxed);
  lost_clicks_.store(meters.lost_clicks, std::memory_order_relaxed);
  const EngineView& view = engine_.view();
  for (std::size_t b = 0; b < drilling_.size(); ++b) {
    drilling_[b].situation.store(view.boom[b].situation, std::memory_order_relaxed);
    drilling_[b].hammering.store(view.boom[b].hammering, std::memory_order_relaxed);
    drilling_[b].impacts_hz.store(view.boom[b].impacts_made_hz, std::memory_order_relaxed);
  }
}

Drilling PlayingRig::drilling(int boom) const noexcept {
  const SharedDrilling& shared = drilling_[static_cast<std::size_t>(boom)];
  return {shared.situation.load(std::memory_order_relaxed), shared.hammering.load(std::memory_order_relaxed),
          shared.impacts_hz.load(std::memory_order_relaxed)};
}

EngineMeters PlayingRig::meters() const noexcept {
  EngineMeters meters;
  meters.peak = peak_.load(std::memory_order_relaxed);
  meters.rms = rms_.load(std::memory_order_relaxed);
  meters.limiter_gain = limiter_gain_.load(std::memory_order_relaxed);
  meters.lost_clicks = lost_clicks_.load(std::memory_order_relaxed);
  return meters;
}

}  // namespace rigsound::library
