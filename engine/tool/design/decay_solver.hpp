// From two wanted decay times to the reflection and the shelf that give them.
#pragma once

#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

struct DecayGains {
  double k = 0;  ///< reflection
  double g = 0;  ///< shelf gain above its corner
};

/// k and g with which `loop` (its delay, allpass, DC blocker and shelf corner) decays as wished at both
/// frequencies; exact where a pole lies there. Throws std::invalid_argument when no passive loop with
/// this corner can. Thread: OFF, CT.
DecayGains solve_decay(const LoopDesign& loop, const DecayWish& wish, double sample_rate);

}  // namespace rigsound::tool
