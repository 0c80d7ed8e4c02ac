#include "rigsound/feed_rule.hpp"

namespace rigsound::scene {
namespace {

/// Whether `x` counts as above `threshold`: it has to pass the far edge of the band to change sides.
bool above(bool was_above, double x, double threshold, double hysteresis) noexcept {
  return was_above ? x > threshold - hysteresis / 2 : x > threshold + hysteresis / 2;
}

}  // namespace

void FeedRule::update(const BoomState& boom) noexcept {
  const double feed = static_cast<double>(boom.feed_pressure_bar);
  in_contact_ = above(in_contact_, feed, options_.contact_bar, options_.hysteresis_bar);
  under_ = !above(!under_, feed, options_.underfeed_bar, options_.hysteresis_bar);
  over_ = above(over_, feed, options_.overfeed_bar, options_.hysteresis_bar);
  hammering_ = boom.percussion == Percussion::kOn || (boom.percussion == Percussion::kFromFeed &&
                                                      (in_contact_ || boom.rattling != Rattling::kNone));
  if (boom.rattling == Rattling::kClosed)
    situation_ = Situation::kClosedRattling;
  else if (boom.rattling == Rattling::kOpen)
    situation_ = Situation::kOpenRattling;
  else
    situation_ = over_ ? Situation::kOverfeed : under_ ? Situation::kUnderfeed : Situation::kNormal;
}

}  // namespace rigsound::scene
