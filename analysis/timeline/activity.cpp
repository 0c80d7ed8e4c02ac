#include "timeline/activity.hpp"

#include <algorithm>

#include "rigsound/feed_rule.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kOffBelow_rpm = 50;  // a diesel that turns slower stands

static_assert(static_cast<int>(Activity::kIdle) == kSituationCount, "the situations come first");

Activity activity(const scene::FeedRule& rule, const MachineState& state) {
  if (rule.hammering()) return static_cast<Activity>(rule.situation());
  return state.engine_rpm < kOffBelow_rpm ? Activity::kOff : Activity::kIdle;
}

/// From `from_s` on it is `now`; a span that had no time to last goes.
void enter(std::vector<ActivitySpan>& spans, Activity now, double from_s, double end_s) {
  if (spans.back().activity == now) return;
  if (from_s <= spans.back().from_s) spans.pop_back();
  if (!spans.empty() && spans.back().activity == now) {
    spans.back().to_s = end_s;
    return;
  }
  if (!spans.empty()) spans.back().to_s = from_s;
  spans.push_back({from_s, end_s, now});
}

}  // namespace

std::vector<ActivitySpan> activity_spans(const session::StateTable& states, int boom,
                                         const SceneOptions& scene, double end_s) {
  MachineState state;
  scene::FeedRule rule(scene);
  rule.update(state.boom[boom]);
  std::vector<ActivitySpan> spans{{0, end_s, activity(rule, state)}};
  for (std::size_t i = 0; i < states.changes.size();) {
    const double time_s = states.changes[i].time_s;
    for (; i < states.changes.size() && states.changes[i].time_s == time_s; ++i) {
      const session::StateChange& change = states.changes[i];
      info(change.signal.signal).set(state, change.signal.boom, change.value);
    }
    if (time_s >= end_s) break;
    rule.update(state.boom[boom]);
    enter(spans, activity(rule, state), std::max(time_s, 0.0), end_s);
  }
  return spans;
}

}  // namespace rigsound::analysis
