// How far a signal can be believed, and what happens when it no longer can.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "rigsound/machine/signal_list.hpp"

namespace rigsound {

#define RIGSOUND_ONE(...) +1
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
  kOutOfRange
};
std::string_view name(Validity v);

/// What happens when a signal is no longer valid: keep its last good value, go to the value that means
/// quiet, or fade the whole rig out.
enum class SafetyAction : std::uint8_t { kHold, kIdle, kMute };

struct SafetyRule {
  double stale_after_s = 0;  ///< age at which the signal goes stale; 0: never
  SafetyAction action = SafetyAction::kHold;
};

struct SafetyOptions {
  std::array<SafetyRule, kSignalCount> rule{};
  double fade_s = 0.3;    ///< time a safety action takes to act, and to let go
  double idle_rpm = 800;  ///< where `idle` brings the diesel, r/min; one that turned slower stays there
};

}  // namespace rigsound
