// Places of a feed among banks, and trends beyond them.
#include "scene/feed_axis.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "bench/formula_sounds.hpp"

using namespace rigsound;

namespace {

double share_of(const scene::FeedPlace& place, const ClickBank& bank) {
  for (int i = 0; i < place.banks.count; ++i)
    if (place.banks.choice[i].bank == &bank) return place.banks.choice[i].share;
  return 0;
}

/// Three banks at the places that the default thresholds give: underfeed 37.5, normal 90, overfeed 150 bar.
struct Three {
  Three() : sounds(tools::formula_sounds()) {}
  scene::FeedAxis axis() const { return scene::FeedAxis(sounds, SceneOptions{}); }
  const ClickBank& normal() const { return sounds.banks[0]; }
  const ClickBank& underfeed() const { return sounds.banks[1]; }
  const ClickBank& overfeed() const { return sounds.banks[2]; }
  SoundSet sounds;
};

}  // namespace

TEST_CASE("a bank without a feed of its own stands where the thresholds put its situation") {
  const scene::FeedPoints points = scene::feed_points(SceneOptions{});
  CHECK(points.underfeed == doctest::Approx((15 + 60) / 2.0));
  CHECK(points.normal == doctest::Approx((60 + 120) / 2.0));
  CHECK(points.overfeed == doctest::Approx(120 + (120 - 90)));
  SceneOptions given;
  given.feed_points.overfeed = 170;
  CHECK(scene::feed_points(given).overfeed == 170);
  CHECK(points.deviation(90) == 0);
  CHECK(points.deviation(150) == doctest::Approx(1));
  CHECK(points.deviation(37.5) == doctest::Approx(-1));
  CHECK(points.deviation(180) == doctest::Approx(1.5));
}

TEST_CASE("between two banks an impact draws each as often as the feed is near it") {
  const Three three;
  const scene::FeedAxis axis = three.axis();
  for (const double w : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const scene::FeedPlace place = axis.place(90 + 60 * w, 1, 0);
    CHECK(share_of(place, three.overfeed()) == doctest::Approx(w).scale(1));
    CHECK(share_of(place, three.normal()) == doctest::Approx(1 - w).scale(1));
    CHECK(place.trend.ln_level == 0);
  }
  // The drawn shares, counted.
  drill::BankChoices banks;
  banks.add(three.normal(), 0.7), banks.add(three.overfeed(), 0.3);
  int over = 0;
  for (int i = 0; i < 10000; ++i) over += &banks.drawn((i + 0.5) / 10000) == &three.overfeed() ? 1 : 0;
  CHECK(over == 3000);
}

TEST_CASE("what a bank is played louder counts in the trend of the level, as what it was recorded louder") {
  Three three;
  const double before = three.axis().place(151, 1, 0).trend.ln_level;
  three.sounds.banks[0].gain_db = -6;  // normal
  const double quieter = three.axis().place(151, 1, 0).trend.ln_level;
  three.sounds.banks[2].gain_db = 6;  // overfeed
  const double both = three.axis().place(151, 1, 0).trend.ln_level;
  const double step = 6 * std::log(10) / 20 / 60;  // nepers a bar
  CHECK((quieter - before) / step == doctest::Approx(1).epsilon(0.01));
  CHECK((both - quieter) / step == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("beyond the outermost banks the trend of the outermost pair goes on, and saturates smoothly") {
  const Three three;
  const scene::FeedAxis axis = three.axis();
  const double slope =
      std::log(three.overfeed().mean_gap_samples / three.normal().mean_gap_samples) / (150 - 90);
  const double level = std::log(three.overfeed().mean_amplitude / three.normal().mean_amplitude) / (150 - 90);
  const scene::FeedPlace just = axis.place(155, 1, 0), far = axis.place(300, 1, 0);
  CHECK(share_of(just, three.overfeed()) == doctest::Approx(1));
  CHECK(just.trend.ln_gap == doctest::Approx(5 * slope).scale(0).epsilon(0.01));
  CHECK(just.trend.ln_level == doctest::Approx(5 * level).scale(0).epsilon(0.01));
  CHECK(std::fabs(far.trend.ln_level) < std::fabs(150 * level) + 1e-9);
  CHECK(std::fabs(far.trend.ln_level) < 1.4);
  double last = 0;
  for (double feed = 150; feed <= 300; feed += 5) {
    const double now = std::fabs(axis.place(feed, 1, 0).trend.ln_level);
    CHECK(now >= last);
    last = now;
  }
}

TEST_CASE("laws of the sound set replace the slopes of the outermost pair") {
  Three three;
  FeedLaws laws;
  laws.ln_decay = 0.002;
  three.sounds.laws = {laws};
  const scene::FeedAxis axis = three.axis();
  CHECK(axis.place(160, 1, 0).trend.ln_decay == doctest::Approx(0.02).scale(0).epsilon(0.01));
  CHECK(axis.place(160, 1, 0).trend.ln_gap == 0);
  CHECK(axis.place(30, 1, 0).trend.ln_decay == doctest::Approx(-0.002 * 7.5).scale(0).epsilon(0.01));
}

TEST_CASE("of several laws the last that holds for the rods and the rock is followed") {
  Three three;
  three.sounds.rocks = {{"soft", 5e7}, {"hard", 5e8}};
  const std::vector<BankUse> uses = three.sounds.uses;
  for (BankUse use : uses) use.rods = 6, three.sounds.uses.push_back(use);
  for (std::size_t i = 0; i < uses.size(); ++i) three.sounds.uses[i].rods = 1;
  const auto law = [](int rods, int rock, double ln_decay) {
    FeedLaws laws;
    laws.rods = rods, laws.rock = rock, laws.ln_decay = ln_decay;
    return laws;
  };
  const auto followed = [&](const std::vector<FeedLaws>& laws, int rods, int rock) {
    three.sounds.laws = laws;
    return std::lround(1000 * three.axis().place(151, rods, rock).trend.ln_decay);  // 1 bar beyond
  };
  const std::vector<FeedLaws> all = {law(0, -1, 0.001), law(6, -1, 0.002), law(0, 1, 0.003),
                                     law(1, 0, 0.004)};
  CHECK(followed(all, 1, -1) == 1);
  CHECK(followed(all, 6, -1) == 2);
  CHECK(followed(all, 1, 1) == 3);
  CHECK(followed(all, 6, 1) == 3);
  CHECK(followed(all, 6, 0) == 2);
  CHECK(followed(all, 1, 0) == 4);
  CHECK(followed({law(6, 1, 0.005)}, 6, 1) == 5);
  for (const auto& [rods, rock] : {std::pair{6, 0}, {1, 1}, {6, -1}, {1, 0}})
    CHECK(followed({law(6, 1, 0.005)}, rods, rock) == followed({}, rods, rock));
}

TEST_CASE("clicks of two known decays give their trend, an unknown one gives none") {
  const auto trend = [](double normal, double overfeed, double feed_bar) {
    Three three;
    three.sounds.banks[1].decay = 200;
    three.sounds.banks[0].decay = normal, three.sounds.banks[2].decay = overfeed;
    return three.axis().place(feed_bar, 1, 0).trend.ln_decay;
  };
  CHECK(trend(200, 400, 153) == doctest::Approx(3 * std::log(2) / 60).scale(0).epsilon(0.001));
  CHECK(trend(400, 200, 153) == doctest::Approx(-3 * std::log(2) / 60).scale(0).epsilon(0.001));
  CHECK(trend(400, 200, 34.5) == doctest::Approx(-3 * std::log(2) / 52.5).scale(0).epsilon(0.001));
  CHECK(trend(0, 400, 153) == 0);
  CHECK(trend(200, 0, 153) == 0);
  CHECK(trend(0, 400, 34.5) == 0);
}

TEST_CASE("between banks of two percussion pressures lies the pressure that impacts are measured against") {
  SoundSet sounds = tools::formula_sounds();
  sounds.uses = {{Situation::kUnderfeed, 1, -1, 2, 40, 120}, {Situation::kNormal, 1, -1, 0, 100, 160},
                 {Situation::kOverfeed, 1, -1, 3, 160, 200}, {Situation::kUnderfeed, 6, -1, 2, 40, 130},
                 {Situation::kNormal, 6, -1, 1, 100, 180},   {Situation::kOverfeed, 6, -1, 3, 160}};
  const scene::FeedAxis axis(sounds, SceneOptions{});
  const auto bar = [&](double feed, double rods) { return axis.place(feed, rods, 0).percussion_bar; };
  CHECK(bar(40, 1) == doctest::Approx(120));
  CHECK(bar(55, 1) == doctest::Approx(130));
  CHECK(bar(130, 1) == doctest::Approx(180));
  CHECK(bar(300, 1) == doctest::Approx(200));
  CHECK(bar(20, 1) == doctest::Approx(120));
  CHECK(bar(300, 6) == doctest::Approx(SceneOptions{}.percussion_nominal_bar));
  CHECK(bar(100, 3) == doctest::Approx(160 + 0.4 * 20));
}

TEST_CASE("a bank that stands alone is all there is at every feed") {
  Three three;
  std::vector<BankUse> uses = {{Situation::kNormal, 1, -1, 0, 80}};
  uses.reserve(2);
  three.sounds.uses = uses;
  const scene::FeedAxis axis = three.axis();
  for (const double feed : {20.0, 80.0, 250.0}) {
    const scene::FeedPlace place = axis.place(feed, 1, 0);
    CHECK(share_of(place, three.normal()) == doctest::Approx(1));
    CHECK(place.trend.ln_gap == 0);
    CHECK(place.trend.ln_level == 0);
    CHECK(place.trend.tilt_db_per_octave == 0);
    CHECK(place.ln_tilted_norm == 0);
  }
}

TEST_CASE("banks placed by their own feed, and two rod counts: in between is in between") {
  SoundSet sounds = tools::formula_sounds();
  sounds.uses = {{Situation::kNormal, 1, -1, 0, 100},    {Situation::kNormal, 6, -1, 1, 100},
                 {Situation::kUnderfeed, 1, -1, 2, 40},  {Situation::kOverfeed, 1, -1, 3, 160},
                 {Situation::kClosedRattling, 0, -1, 3}, {Situation::kOpenRattling, 0, -1, 4}};
  const scene::FeedAxis axis(sounds, SceneOptions{});
  CHECK(share_of(axis.place(100, 1, 0), sounds.banks[0]) == doctest::Approx(1));
  CHECK(share_of(axis.place(100, 6, 0), sounds.banks[1]) == doctest::Approx(1));
  CHECK(share_of(axis.place(100, 20, 0), sounds.banks[1]) == doctest::Approx(1));
  CHECK(share_of(axis.place(100, 3, 0), sounds.banks[1]) == doctest::Approx(0.4));
  CHECK(share_of(axis.place(130, 3, 0), sounds.banks[3]) ==
        doctest::Approx(0.5));  // both counts share the overfeed bank
}

TEST_CASE(
    "rods and rock that nobody recorded are as loud as the string makes them, recorded ones as they are") {
  Three three;
  three.sounds.strings = {StringModel{}};
  three.sounds.rocks = {{"soft", 5e7}, {"hard", 5e8}};
  const double joint = 0.5 * std::log(joint_transmission(StringModel{}));
  const auto passes = [](double stiffness) {
    return 0.5 * std::log(energy_passes(StringModel{}, stiffness));
  };
  const double soft = passes(5e7) - passes(2e8), hard = passes(5e8) - passes(2e8);
  const auto level = [&](int string, double rods, int rock) {
    return scene::FeedAxis(three.sounds, SceneOptions{}, string).place(100, rods, rock).trend.ln_level;
  };
  CHECK(joint < -0.01);
  CHECK(level(0, 1, -1) == 0);
  CHECK(level(0, 6, -1) == doctest::Approx(5 * joint));
  CHECK(level(0, 20, -1) == doctest::Approx(19 * joint));
  CHECK(level(0, 1, 0) == doctest::Approx(soft));
  CHECK(level(0, 6, 1) == doctest::Approx(hard + 5 * joint));
  CHECK(level(0, 1, 7) == 0);  // a rock that the sound set does not have
  CHECK(level(-1, 20, 0) == 0);

  // Six rods recorded too, and on hard rock.
  const std::vector<BankUse> uses = three.sounds.uses;
  for (BankUse use : uses) use.rods = 6, use.rock = 1, three.sounds.uses.push_back(use);
  for (std::size_t i = 0; i < uses.size(); ++i) three.sounds.uses[i].rods = 1;
  CHECK(level(0, 6, 1) == doctest::Approx(0).scale(1));
  CHECK(level(0, 20, 1) == doctest::Approx(14 * joint));
  CHECK(level(0, 3, 1) == doctest::Approx(0).scale(1));
  CHECK(level(0, 1, 0) == doctest::Approx(soft));
}
