// Sound sets that are known: what can be told apart in them is told, what cannot is named.
#include "rigsound/analysis/contrast.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "analysis/contrast/impact_sounds.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

ContrastPlan plan() {
  ContrastPlan p;
  p.sound_set = "sounds";
  p.points = {60, 90, 120};
  p.lowest_bar = 40, p.highest_bar = 140;
  const auto add = [&](const char* name, const char* bank, double feed_bar, Rattling rattling) {
    p.situations.push_back({name, {bank}, {feed_bar, rattling, 1, 0}});
  };
  add("normal", "a", 90, Rattling::kNone);
  add("underfeed", "b", 60, Rattling::kNone);
  add("overfeed", "c", 120, Rattling::kNone);
  add("closed rattling", "d", 0, Rattling::kClosed);
  add("open rattling", "e", 0, Rattling::kOpen);
  return p;
}

/// Louder by `db_per_bar` and faster by `rate_per_bar` (share) a bar away from normal; below it nothing
/// changes unless `below`.
struct Laws {
  double db_per_bar = 0, rate_per_bar = 0;
};

RenderSound rendered_by(const Laws& above, const Laws& below) {
  return [=](const DrillSetting& setting, double seconds, std::uint64_t seed) {
    ImpactSound s;
    if (setting.rattling != Rattling::kNone) {
      s.rate_hz = setting.rattling == Rattling::kClosed ? 20 : 12;
      s.tilt = 0.9;
    } else {
      const double away = setting.feed_bar - 90;
      const Laws& laws = away > 0 ? above : below;
      s.level *= std::pow(10, laws.db_per_bar * away / 20);
      s.rate_hz *= std::exp(laws.rate_per_bar * away);
    }
    return RenderedSound{impact_sound(s, seconds, static_cast<unsigned>(seed)), {}};
  };
}

ContrastOptions options() {
  ContrastOptions o;
  o.seconds = 8, o.runs = 3, o.jobs = 2;
  return o;
}

const PairFigures& pair(const SubjectGroup& group, std::size_t first, std::size_t second) {
  return *std::find_if(group.pairs.begin(), group.pairs.end(),
                       [&](const PairFigures& p) { return p.first == first && p.second == second; });
}

bool mentions(const std::vector<std::string>& lines, const std::string& text) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("laws of level and rate are measured, and what is heard lies where its size says" *
          doctest::test_suite("long")) {
  std::atomic<int> calls{0};
  int last = 0, last_of = 0;
  const RenderSound render = rendered_by({0.2, 0}, {0, 0.006});
  const Contrast c = measure_contrast(
      plan(), options(),
      [&](const DrillSetting& s, double seconds, std::uint64_t seed) {
        ++calls;
        return render(s, seconds, seed);
      },
      [&](int done, int of) { last = done, last_of = of; });
  CHECK(last == calls);
  CHECK(last <= last_of);
  CHECK(pair(c.situations, 0, 2).third_octave_db == doctest::Approx(6).epsilon(0.05));
  CHECK(pair(c.situations, 0, 2).phon == doctest::Approx(6).epsilon(0.15));
  CHECK(pair(c.situations, 0, 2).rate < 0.01);
  CHECK(pair(c.situations, 0, 1).rate == doctest::Approx(0.18).scale(0).epsilon(0.05));
  CHECK(pair(c.situations, 0, 1).told_apart());
  CHECK(contrast_warnings(c).empty());
  // The louder side: noise of 2 dB in each of 25 bands, so that 1.349 standard deviations are 0.54 dB for the
  // best of listeners; this one has to learn, and the excerpts differ by themselves.
  CHECK(c.over.found);
  CHECK(c.over.away_bar > 2);
  CHECK(c.over.away_bar < 8);
  CHECK(c.over.low_bar <= c.over.away_bar);
  CHECK(c.over.away_bar <= c.over.high_bar);
  CHECK(c.under.found);
  for (const FeedFigures& f : c.feed)
    if (f.feed_bar > 94)
      CHECK(f.third_octave_db == doctest::Approx(0.2 * (f.feed_bar - 90)).scale(0).epsilon(0.3));
}

TEST_CASE("a copied bank is named, and that nothing is heard at any feed" * doctest::test_suite("long")) {
  ContrastPlan copied = plan();
  copied.situations[2].banks = {"a"};
  const Contrast c = measure_contrast(copied, options(), rendered_by({0, 0}, {0.2, 0}), [](int, int) {});
  const PairFigures& same = pair(c.situations, 0, 2);
  CHECK(same.third_octave_db == doctest::Approx(same.third_octave_floor_db).scale(0).epsilon(0.25));
  CHECK_FALSE(same.above_floor());
  CHECK_FALSE(same.told_apart());
  CHECK_FALSE(c.over.found);
  CHECK(c.under.found);
  const std::vector<std::string> warnings = contrast_warnings(c);
  CHECK(mentions(warnings, "sounds: warning: overfeed cannot be told from normal"));
  CHECK(mentions(warnings, "both are played from bank a"));
  CHECK(mentions(warnings, "overfeed cannot be heard at any feed above normal"));
  CHECK_FALSE(mentions(warnings, "underfeed"));
  CHECK(mentions(contrast_verdicts(c), "Overfeed cannot be heard"));
  CHECK(mentions(contrast_verdicts(c), "Not told apart: normal and overfeed."));
}

TEST_CASE("figures do not depend on how many jobs make them, and the page holds all of it" *
          doctest::test_suite("long")) {
  ContrastOptions one = options();
  one.seconds = 4, one.runs = 2, one.jobs = 1;
  ContrastOptions two = one;
  two.jobs = 2;
  ContrastPlan small = plan();
  small.highest_bar = 110;
  small.rods = {{"1 rod", {}, {90, Rattling::kNone, 1, 0}}, {"6 rods", {}, {90, Rattling::kNone, 6, 0}}};
  const RenderSound render = rendered_by({0.2, 0}, {0.2, 0});
  const Contrast a = measure_contrast(small, one, render, [](int, int) {}),
                 b = measure_contrast(small, two, render, [](int, int) {});
  REQUIRE(a.feed.size() == b.feed.size());
  for (std::size_t i = 0; i < a.feed.size(); ++i) {
    CHECK(a.feed[i].feed_bar == b.feed[i].feed_bar);
    CHECK(a.feed[i].right == b.feed[i].right);
    CHECK(a.feed[i].third_octave_db == b.feed[i].third_octave_db);
  }
  CHECK(mentions(contrast_warnings(a), "6 rods cannot be told from 1 rod"));
  const test::TemporaryFolder folder;
  write_contrast_page(folder.path / "page.html", a);
  const std::string page = test::content(folder.path / "page.html");
  CHECK(page.find("prefers-color-scheme: dark") != std::string::npos);
  CHECK(page.find("Told from normal within one second") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);  // nothing from elsewhere
  CHECK(page.find("6 rods") != std::string::npos);
}
