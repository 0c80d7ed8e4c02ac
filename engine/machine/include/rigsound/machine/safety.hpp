// How far a signal can be believed, and what happens when it no longer can.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/signal_list.hpp"

namespace rigsound {

#define RIGSOUND_ONE(...) +1  // NOLINT(bugprone-macro-parentheses): a term of a sum
constexpr int kSignalCount = 0 RIGSOUND_RIG_SIGNALS(RIGSOUND_ONE) RIGSOUND_BOOM_SIGNALS(RIGSOUND_ONE);
#undef RIGSOUND_ONE

/// Why a signal may not be believed.
enum class Validity : std::uint8_t {
  kNeverSeen,
  kValid,
  kStale,
  kBusDown,
  kErrorValue,
  kNotAvailable,
  kOutOfRange,
  kManual  ///< a user holds it: what buses say does not count
};
constexpr int kValidityCount = 8;
std::string_view name(Validity v);

/// What happens when a signal is no longer valid: keep its last good value, go to the value that means
/// quiet, or fade the whole rig out.
enum class SafetyAction : std::uint8_t { kHold, kIdle, kMute };

constexpr Word<SafetyAction> kSafetyActions[] = {
    {"hold", SafetyAction::kHold}, {"idle", SafetyAction::kIdle}, {"mute", SafetyAction::kMute}};

constexpr Range kStaleAges{0, 3600, "s"};

struct SafetyRule {
  double stale_after_s = 0;  ///< age at which the signal goes stale; 0: never
  SafetyAction action = SafetyAction::kHold;
};

template <class Archive>
void fields(Archive& a, SafetyRule& o) {
  a("action", o.action, kSafetyActions);
  a("stale_after_s", o.stale_after_s, kStaleAges);
}

struct SafetyOptions {
  std::array<SafetyRule, kSignalCount> rule{};
  double fade_s = 0.3;     ///< time a safety action takes to act, and to let go
  double max_laeq_db = 0;  ///< dB(A): A-weighted level over a minute that the output stays below; 0: any
  double idle_rpm = 800;   ///< where `idle` brings the diesel, r/min; one that turned slower stays there
};

/// What no signal and no other section says.
template <class Archive>
void fields(Archive& a, SafetyOptions& o) {
  a("fade_s", o.fade_s, Range{0, 60, "s"});
  a("max_laeq_db", o.max_laeq_db, Range{40, 120, "dB"}.or_zero());
}

}  // namespace rigsound
