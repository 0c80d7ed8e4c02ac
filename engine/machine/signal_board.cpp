#include "rigsound/machine/signal_board.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound {

namespace {

template <class Entries>
auto& entry_of(Entries& entries, SignalId id) noexcept {
  return entries[static_cast<std::size_t>(id.signal)][std::min<int>(id.boom, kMaxBooms - 1)];
}

}  // namespace

const SignalBoard::Entry& SignalBoard::entry(SignalId id) const noexcept { return entry_of(entries_, id); }

void SignalBoard::hold(SignalId id, double value) noexcept {
  Entry& entry = entry_of(entries_, id);
  entry.by_hand = true;
  entry.hand_value = value;
}

void SignalBoard::release(SignalId id) noexcept { entry_of(entries_, id).by_hand = false; }

Validity SignalBoard::take(const Reading& reading) noexcept {
  Entry& entry = entry_of(entries_, reading.id);
  const SignalInfo& limits = info(reading.id.signal);
  Validity validity = reading.validity;
  double value = reading.value;
  if (validity == Validity::kValid) {
    if (limits.kind == SignalKind::kClampedNumber && value > limits.max && value <= 2 * limits.max) {
      value = limits.max;
      ++entry.clamped;
    }
    if (!limits.takes(value)) {
      validity = Validity::kOutOfRange;
      entry.last_refused = reading.value;
    }
  }
  if (validity != Validity::kValid) {
    const bool told = validity != Validity::kBusDown && validity != Validity::kStale;
    if (told) {
      ++entry.refused;
      entry.last_refusal = validity;
    }
    if (!entry.ever_good()) entry.value = limits.absent;
    if (entry.validity != Validity::kNeverSeen || told) entry.validity = validity;
    return validity;
  }
  entry.value = limits.stepped() ? std::floor(value + 0.5) : value;
  entry.seen_s = reading.time_s;
  entry.validity = validity;
  if (reading.id.signal == Signal::kEngineRpm) speed_.message(reading.time_s, value);
  return validity;
}

Validity SignalBoard::validity(SignalId id, const SafetyRule& rule, double now_s) const noexcept {
  const Entry& e = entry(id);
  if (e.by_hand) return Validity::kManual;
  const bool old = rule.stale_after_s > 0 && now_s - e.seen_s > rule.stale_after_s;
  return e.validity == Validity::kValid && old ? Validity::kStale : e.validity;
}

}  // namespace rigsound
