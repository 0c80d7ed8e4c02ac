#include "rigsound/machine/state_resolver.hpp"

#include <algorithm>
#include <limits>

#include "rigsound/dsp/ramp.hpp"

namespace rigsound {
namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// One bad value between good ones is no reason to act: an error, a missing or an impossible value counts
/// when the last good one has grown stale. A bus that is down counts at once.
bool believed(const SignalBoard::Entry& entry, Validity now, const SafetyRule& rule, double now_s) noexcept {
  switch (now) {
    case Validity::kNeverSeen:
    case Validity::kValid:
      return true;
    case Validity::kStale:
    case Validity::kBusDown:
      return false;
    default:
      return rule.stale_after_s > 0 && now_s - entry.seen_s <= rule.stale_after_s;
  }
}

double rest_value(Signal s, double last_good, const SafetyOptions& safety) noexcept {
  if (safety.rule[static_cast<std::size_t>(s)].action != SafetyAction::kIdle) return last_good;
  return s == Signal::kEngineRpm ? std::min(last_good, safety.idle_rpm) : info(s).idle;
}

/// The bus says what was true at its message's time; the engine is told what is true now, and how it goes on.
void set_speed(const SignalBoard& board, double now_s, double fallback_mix, MachineState& state) noexcept {
  const SignalBoard::Entry& entry = board.entry({Signal::kEngineRpm});
  if (entry.by_hand || entry.validity == Validity::kNeverSeen) return;
  const SpeedTrend speed = board.speed().at(now_s);
  state.engine_rpm += static_cast<float>((speed.rpm - entry.value) * (1 - fallback_mix));
  state.engine_rpm_slope = static_cast<float>(speed.slope * (1 - fallback_mix));
}

}  // namespace

void StateResolver::expect_change(double time_s) noexcept {
  next_change_s_ = std::min(next_change_s_, time_s);
}

void StateResolver::fade(double& mix, double target) noexcept {
  mix = dsp::step_towards(mix, target, step_);
  fading_ = fading_ || mix != target;
}

StateResolver::Standing StateResolver::resolve_signal(SignalId id, const SignalBoard& board,
                                                      const SafetyOptions& safety, double now_s) noexcept {
  const SignalInfo& signal = info(id.signal);
  const SignalBoard::Entry& entry = board.entry(id);
  as_told_ = as_told_ && !entry.by_hand;
  if (entry.by_hand) return {entry.hand_value, 0};
  if (entry.validity == Validity::kNeverSeen) return {signal.absent, 0};
  const SafetyRule& rule = safety.rule[static_cast<std::size_t>(id.signal)];
  const bool good = believed(entry, board.validity(id, rule, now_s), rule, now_s);
  if (good && rule.stale_after_s > 0) expect_change(entry.seen_s + rule.stale_after_s);
  muted_ = muted_ || (!good && rule.action == SafetyAction::kMute);
  double& mix = fallback_mix_[static_cast<std::size_t>(id.signal)][id.boom];
  fade(mix, good ? 0.0 : 1.0);
  as_told_ = as_told_ && mix == 0;
  const double rest = rest_value(id.signal, entry.value, safety);
  if (signal.stepped()) return {good ? entry.value : rest, mix};
  return {entry.value + (rest - entry.value) * mix, mix};
}

MachineState StateResolver::resolve(const SignalBoard& board, const SafetyOptions& safety,
                                    double now_s) noexcept {
  // A fade begins when it is seen to be due, not at the last resolve, which may be long ago.
  const double elapsed = fading_ ? std::max(0.0, now_s - last_s_) : 0.0;
  step_ = safety.fade_s > 0 ? elapsed / safety.fade_s : 1.0;
  last_s_ = now_s;
  next_change_s_ = kNever_s;
  fading_ = muted_ = false;
  as_told_ = true;

  MachineState state;
  double speed_mix = 0;
  for_each_signal(kMaxBooms, [&](SignalId id) {
    const Standing standing = resolve_signal(id, board, safety, now_s);
    value_[static_cast<std::size_t>(id.signal)][id.boom] = standing.value;
    info(id.signal).set(state, id.boom, standing.value);
    if (board.entry(id).by_hand) mark_by_hand(state, id);
    if (id.signal == Signal::kEngineRpm) speed_mix = standing.fallback_mix;
  });
  set_speed(board, now_s, speed_mix, state);
  double silence = 1 - safety_gain_;
  fade(silence, muted_ ? 1.0 : 0.0);
  safety_gain_ = 1 - silence;
  state.output_gain = static_cast<float>(safety_gain_);
  if (fading_) next_change_s_ = now_s;
  return state;
}

}  // namespace rigsound
