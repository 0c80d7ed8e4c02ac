// Which of the loops that are tried is taken.
#include "tool/design/loop_designer.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "rigsound/tool_model.hpp"

using namespace rigsound;
using namespace rigsound::tool;

namespace {

const Bar kStretchedBars[] = {{0.3, 0.03}, {0.4, 0.02}, {0.5, 0.025}, {0.7, 0.03}, {1.0, 0.05}};

/// Stretching bars, few orders; no loop reaches the aim, so that the search ends for other reasons.
LoopTask endless_search() {
  LoopTask task;
  task.filters = {0.002, 0.5, 0.8};
  task.cents = 0, task.cents_limit = 1000;
  task.decay_share = 1;
  task.lowest_order = 1, task.preferred_order = 5, task.max_order = 5;
  task.spare_delay = 1e3;
  return task;
}

}  // namespace

TEST_CASE("a decay that is good enough is no reason to take a loop that is tuned worse") {
  for (const Bar& bar : kStretchedBars) {
    CAPTURE(bar.length_m);
    LoopTask task = endless_search();
    const DesignedLoop found = design_loop(LongitudinalLaw(bar), task);
    REQUIRE(found.error.decay_share < 1);
    task.decay_share = 1e9;  // no decay counts
    CHECK(design_loop(LongitudinalLaw(bar), task).error.cents == found.error.cents);
  }
}

TEST_CASE("a loop of the preferred order is tried though one of a lower order is accepted") {
  int better = 0;
  for (const Bar& bar : kStretchedBars) {
    CAPTURE(bar.length_m);
    LoopTask task = endless_search();
    const double preferred = design_loop(LongitudinalLaw(bar), task).error.cents;
    task.preferred_order = 6;  // one more than there may be
    CHECK(preferred == design_loop(LongitudinalLaw(bar), task).error.cents);
    task.preferred_order = 5, task.max_order = 4;
    better += preferred < design_loop(LongitudinalLaw(bar), task).error.cents ? 1 : 0;
  }
  CHECK(better > 0);
}

TEST_CASE(
    "at half the rate a bending loop has turned as far as the bar's law, or on straight if that is less") {
  for (const double rate : {44100.0, 96000.0})
    for (const Bar& bar : kStretchedBars) {
      ToolModel model;
      model.bar = bar;
      const LoopDesign loop = design_tool(model, rate).transversal;
      const TransversalLaw law(bar);
      double top = 1;
      while (law.at(top) < rate / 2) top += 1e-3;
      const int modes = law.count_below(mode_limit(rate));
      const double straight = modes + (rate / 2 - law.at(modes)) * law.density(modes);
      const double half_turns = 2 * std::min(top, straight);
      CAPTURE(rate);
      CAPTURE(bar.length_m);
      // Its delay and each order turn by pi there. Whole numbers are tried from two less to one more.
      CHECK(loop.delay_samples + loop.allpass.order() >= half_turns - 2);
      CHECK(loop.delay_samples + loop.allpass.order() <= half_turns + 2);
    }
}
