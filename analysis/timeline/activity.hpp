// What a boom is doing, as spans of time.
#pragma once

#include <vector>

#include "rigsound/options.hpp"
#include "rigsound/session/state_table.hpp"

namespace rigsound::analysis {

/// The situations, in their order, then what there is beside drilling.
enum class Activity : std::uint8_t {
  kNormal,
  kUnderfeed,
  kOverfeed,
  kClosedRattling,
  kOpenRattling,
  kIdle,  ///< the diesel runs, the hammer does not
  kOff,
};
constexpr int kActivityCount = 7;

struct ActivitySpan {
  double from_s, to_s;
  Activity activity;
};

/// Spans without gaps from 0 to `end_s`, neighbours differ. The situation is the engine's own rule,
/// hysteresis included. Thread: OFF.
std::vector<ActivitySpan> activity_spans(const session::StateTable& states, int boom,
                                         const SceneOptions& scene, double end_s);

}  // namespace rigsound::analysis
