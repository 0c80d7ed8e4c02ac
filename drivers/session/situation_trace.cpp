#include "rigsound/session/situation_trace.hpp"

#include <cmath>

namespace rigsound::session {

SituationTrace::Change SituationTrace::update(const BoomState& boom) {
  Change change;
  rule_.update(boom);
  if (situation_ != rule_.situation()) change.situation = situation_ = rule_.situation();
  // As the engine hears it: a parted string has nothing to press against.
  const bool broken = boom.rod_broken == RodBroken::kYes;
  const double deviation = points_.deviation(broken ? 0.0 : static_cast<double>(boom.feed_pressure_bar));
  if (!deviation_ || std::fabs(deviation - *deviation_) >= kDeviationStep)
    change.feed_deviation = deviation_ = std::round(deviation * 100) / 100;
  return change;
}

}  // namespace rigsound::session
