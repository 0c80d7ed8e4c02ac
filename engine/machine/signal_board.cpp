#include "rigsound/machine/signal_board.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound {
namespace {

double step_towards(double from, double to, double step) {
  return from < to ? std::min(to, from + step) : std::max(to, from - step);
}

// One bad value between good ones is no reason to act: an error, a missing or an impossible value counts
// when the last good one has grown stale. A bus that is down counts at once.
bool distrusted(const SignalBoard::Reading& r, const SafetyRule& rule, double now_s) {
  switch (r.validity) {
    case Validity::kNeverSeen:
    case Validity::kValid:
      return false;
    case Validity::kStale:
    case Validity::kBusDown:
      return true;
    default:
      return rule.stale_after_s <= 0 || now_s - r.seen_s > rule.stale_after_s;
  }
}

}  // namespace

SignalBoard::SignalBoard(const SafetyOptions& options) : options_(options) {
  for (std::size_t s = 0; s < cells_.size(); ++s)
    for (Cell& c : cells_[s]) c.reading.value = c.shown = signal_table()[s].absent;
}

const SignalBoard::Cell& SignalBoard::cell(SignalId id) const {
  return cells_[static_cast<std::size_t>(id.signal)][std::min<std::size_t>(id.boom, kMaxBooms - 1)];
}

SignalBoard::Cell& SignalBoard::cell(SignalId id) {
  return const_cast<Cell&>(static_cast<const SignalBoard*>(this)->cell(id));
}

Validity SignalBoard::update(SignalId id, double value, double time_s) {
  Reading& r = cell(id).reading;
  const SignalInfo& limits = info(id.signal);
  const bool in_range = value >= limits.min && value <= limits.max;
  if (!in_range && value != limits.absent) {
    invalidate(id, Validity::kOutOfRange);
    return Validity::kOutOfRange;
  }
  r.value = limits.stepped ? std::floor(value + 0.5) : value;
  r.seen_s = time_s;
  r.validity = Validity::kValid;
  return r.validity;
}

void SignalBoard::invalidate(SignalId id, Validity why) {
  Reading& r = cell(id).reading;
  if (r.validity != Validity::kNeverSeen) r.validity = why;
}

SignalBoard::Reading SignalBoard::reading_of(const Cell& c, Signal s, double now_s) const {
  Reading r = c.reading;
  const double limit = options_.rule[static_cast<std::size_t>(s)].stale_after_s;
  if (r.validity == Validity::kValid && limit > 0 && now_s - r.seen_s > limit) r.validity = Validity::kStale;
  return r;
}

SignalBoard::Reading SignalBoard::reading(SignalId id, double now_s) const {
  return reading_of(cell(id), id.signal, now_s);
}

double SignalBoard::rest_value(Signal s, double last_good) const {
  if (options_.rule[static_cast<std::size_t>(s)].action != SafetyAction::kIdle) return last_good;
  return s == Signal::kEngineRpm ? std::min(last_good, options_.idle_rpm) : info(s).idle;
}

void SignalBoard::settle(Signal s, Cell& c, double now_s, double step, bool& mute) {
  const SafetyRule& rule = options_.rule[static_cast<std::size_t>(s)];
  if (c.reading.validity == Validity::kNeverSeen) return;
  c.reading = reading_of(c, s, now_s);
  const bool good = !distrusted(c.reading, rule, now_s);
  mute = mute || (!good && rule.action == SafetyAction::kMute);
  c.distrust = step_towards(c.distrust, good ? 0.0 : 1.0, step);
  const double rest = rest_value(s, c.reading.value);
  if (info(s).stepped)
    c.shown = good ? c.reading.value : rest;
  else
    c.shown = c.reading.value + (rest - c.reading.value) * c.distrust;
}

MachineState SignalBoard::resolve(double now_s) {
  const double elapsed = started_ ? std::max(0.0, now_s - last_s_) : 0.0;
  const double share = options_.fade_s > 0 ? elapsed / options_.fade_s : 1.0;
  started_ = true;
  last_s_ = now_s;
  bool mute = false;
  for (int s = 0; s < kSignalCount; ++s)
    for (Cell& c : cells_[static_cast<std::size_t>(s)]) settle(static_cast<Signal>(s), c, now_s, share, mute);
  safety_gain_ = step_towards(safety_gain_, mute ? 0.0 : 1.0, share);

  MachineState state;
  const auto shown = [this](Signal s, std::uint8_t boom = 0) { return resolved({s, boom}); };
  state.engine_rpm = static_cast<float>(shown(Signal::kEngineRpm));
  state.engine_load = static_cast<float>(shown(Signal::kEngineLoad));
  state.master_gain_db = static_cast<float>(shown(Signal::kMasterGainDb));
  state.safety_gain = static_cast<float>(safety_gain_);
  for (std::uint8_t b = 0; b < kMaxBooms; ++b) {
    BoomState& boom = state.boom[b];
    boom.feed_pressure_bar = static_cast<float>(shown(Signal::kFeedPressureBar, b));
    boom.rattling = static_cast<Rattling>(shown(Signal::kRattling, b));
    boom.percussion = static_cast<Percussion>(shown(Signal::kPercussion, b));
    boom.percussion_rate_hz = static_cast<float>(shown(Signal::kPercussionRateHz, b));
    boom.rod_count = static_cast<std::uint8_t>(shown(Signal::kRodCount, b));
    boom.rock = static_cast<std::uint16_t>(shown(Signal::kRock, b));
  }
  return state;
}

double SignalBoard::resolved(SignalId id) const { return cell(id).shown; }

}  // namespace rigsound
