// Where the trends of a sound set flatten.
#include "rigsound/feed_reach.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bench/formula_sounds.hpp"
#include "scene/feed_axis.hpp"

using namespace rigsound;

namespace {

double limit_of(const scene::FeedReach& reach, std::string_view parameter, bool above) {
  for (const scene::TrendLimit& limit : reach.limits)
    if (limit.parameter == parameter && (limit.feed_bar >= reach.highest_bar) == above) return limit.feed_bar;
  return 0;
}

}  // namespace

TEST_CASE("a trend has flattened where the sound follows the feed by half of its law") {
  SoundSet sounds = tools::formula_sounds();
  FeedLaws laws;
  laws.ln_decay = 0.02, laws.ln_level = 0.001;
  laws.gap_variation = -0.0005;
  for (ClickBank& bank : sounds.banks) bank.gap_deviation_samples = 0.02 * bank.mean_gap_samples;
  sounds.laws = {laws};
  const std::vector<scene::FeedReach> all = scene::feed_reach(sounds, SceneOptions{});
  REQUIRE(!all.empty());
  const scene::FeedReach& reach = all.front();
  CHECK(reach.rock == -1);
  CHECK(reach.banks == 3);
  CHECK(reach.lowest_bar == 37.5);
  CHECK(reach.highest_bar == 150);

  const scene::FeedAxis axis(sounds, SceneOptions{});
  const double bar = limit_of(reach, "decay", true), step = 0.01;
  REQUIRE(bar > 150);
  const auto decay = [&](double feed) { return axis.place(feed, 1, -1).trend.ln_decay; };
  CHECK((decay(bar + step) - decay(bar - step)) / (2 * step) == doctest::Approx(0.01).scale(0).epsilon(0.01));
  CHECK(limit_of(reach, "level", true) == 0);            // follows to 300 bar
  CHECK(limit_of(reach, "gap variation", true) == 190);  // 0.02 is used up after 40 bar
  CHECK(limit_of(reach, "rate", true) == 0);
}

TEST_CASE("a limit is told as long as it lies within the signal's range, on either side") {
  SoundSet sounds = tools::formula_sounds();
  for (const double bar : {100.0, 149.0, 151.0, 400.0}) {  // from an end to where the level stops to follow
    FeedLaws laws;
    laws.ln_level = 1.4 * std::sqrt(std::cbrt(4.0) - 1) / bar;  // the slope has halved there
    sounds.laws = {laws};
    const std::vector<scene::FeedReach> all = scene::feed_reach(sounds, SceneOptions{});
    CAPTURE(bar);
    CHECK(limit_of(all.front(), "level", true) == doctest::Approx(bar < 150 ? 150 + bar : 0).epsilon(1e-3));
    CHECK(limit_of(all.front(), "level", false) == 0);
  }
  FeedLaws laws;
  laws.ln_level = 1.4 * std::sqrt(std::cbrt(4.0) - 1) / 30;
  sounds.laws = {laws};
  CHECK(limit_of(scene::feed_reach(sounds, SceneOptions{}).front(), "level", false) ==
        doctest::Approx(37.5 - 30).epsilon(1e-3));
}

TEST_CASE("every rod count and rock with banks has its reach") {
  SoundSet sounds = tools::formula_sounds();
  sounds.rocks = {{"soft", 5e7}};
  sounds.uses = {{Situation::kNormal, 1, -1, 0, 80},     {Situation::kNormal, 6, -1, 1, 100},
                 {Situation::kUnderfeed, 1, -1, 2, 40},  {Situation::kOverfeed, 1, -1, 3, 160},
                 {Situation::kClosedRattling, 0, -1, 3}, {Situation::kOpenRattling, 0, -1, 4}};
  const std::vector<scene::FeedReach> all = scene::feed_reach(sounds, SceneOptions{});
  REQUIRE(all.size() == 4);
  CHECK(all[0].rods == 1);
  CHECK(all[1].rods == 6);
  CHECK(all[2].rock == 0);
  CHECK(all[0].lowest_bar == 40);
  CHECK(all[0].highest_bar == 160);
}
