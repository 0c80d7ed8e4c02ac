// A debrief's rows are the engine's own rule, told when something has changed.
#include "rigsound/session/situation_trace.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace rigsound;
using session::SituationTrace;

namespace {

BoomState fed(double bar) {
  BoomState boom;
  boom.feed_pressure_bar = static_cast<float>(bar);
  return boom;
}

}  // namespace

TEST_CASE("the first state tells everything, the same state nothing more") {
  SituationTrace trace(SceneOptions{});  // underfeed at 37.5 bar, normal at 90, overfeed at 150
  const SituationTrace::Change first = trace.update(fed(90));
  CHECK(first.situation == Situation::kNormal);
  CHECK(first.feed_deviation == 0.0);
  const SituationTrace::Change again = trace.update(fed(90));
  CHECK_FALSE(again.situation);
  CHECK_FALSE(again.feed_deviation);
}

TEST_CASE("a deviation is told in steps, also when the feed creeps, and noise around a step is not") {
  SituationTrace trace(SceneOptions{});
  double told = *trace.update(fed(90)).feed_deviation;
  int count = 0;
  for (double bar = 90; bar <= 150; bar += 0.1) {
    const auto deviation = trace.update(fed(bar)).feed_deviation;
    if (!deviation) continue;
    CHECK(*deviation - told >= SituationTrace::kDeviationStep - 0.01);
    CHECK(*deviation == doctest::Approx((bar - 90) / 60).epsilon(0.02));
    told = *deviation;
    ++count;
  }
  CHECK(count >= 18);
  CHECK(count <= 20);
  for (int i = 0; i < 1000; ++i) {
    const double noise_bar = std::sin(i) * 1.2;  // of a step of 3 bar
    CHECK_FALSE(trace.update(fed(60 * told + 90 + noise_bar)).feed_deviation);
  }
}

TEST_CASE("situations change with the hysteresis of the scene, and a parted string is not pressed on") {
  SituationTrace trace(SceneOptions{});
  CHECK(trace.update(fed(122)).situation == Situation::kNormal);
  CHECK(trace.update(fed(124)).situation == Situation::kOverfeed);
  CHECK_FALSE(trace.update(fed(118)).situation);
  BoomState broken = fed(118);
  broken.rod_broken = RodBroken::kYes;
  CHECK(trace.update(broken).feed_deviation == doctest::Approx((0 - 90) / 52.5).epsilon(0.01));
}
