// Every bar of feed is in the sound: places among banks, trends beyond them, and what the scene makes of
// them.
#include "scene/feed_axis.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"
#include "scene/boom_scene.hpp"

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

TEST_CASE("impacts come at the rate asked for, 5 to 120 Hz, whatever feed and rods, missed ones counted") {
  SoundSet sounds = tools::formula_sounds();
  for (ClickBank& bank : sounds.banks) bank.miss_share = 0.05, bank.double_share = 0.05;
  const EngineOptions options = tools::full_options();
  for (const double rate : {5.0, 23.0, 60.0, 120.0})
    for (const double feed : {30.0, 110.0, 250.0}) {
      scene::BoomScene boom(options, sounds, 0);
      impact::ImpactTrain train(5, 0);
      BoomState state;
      state.feed_pressure_bar = static_cast<float>(feed);
      state.percussion_rate_hz = static_cast<float>(rate);
      boom.set(state);
      for (int i = 0; i < 2000; ++i) boom.advance();
      const double seconds = 4000 / rate;
      double first = -1, last = -1;
      int made = 0;
      for (double start = 0; start < seconds * 48000; start += kChunk) {
        boom.advance();
        train.process(boom.impacts());
        for (const Impact& impact : train.impacts()) {
          last = start + impact.onset;
          if (first < 0) first = last;
          ++made;
        }
      }
      const double per_schedule =
          1 - 0.05 / (1 + 0.05) + 0.05 / (1 + 0.05);  // a miss takes one away, a double adds one
      CHECK_MESSAGE(
          (made - 1) / ((last - first) / 48000) == doctest::Approx(rate * per_schedule).epsilon(0.01), rate,
          " Hz, ", feed, " bar");
    }
}

TEST_CASE(
    "without a rate on the bus it goes with the root of the percussion pressure, the energy with the "
    "pressure") {
  const SoundSet sounds = tools::formula_sounds();
  const EngineOptions options = tools::full_options();
  const auto at = [&](double bar) {
    scene::BoomScene boom(options, sounds, 0);
    BoomState state;
    state.feed_pressure_bar = 90;
    state.percussion_pressure_bar = static_cast<float>(bar);
    boom.set(state);
    for (int i = 0; i < 2000; ++i) boom.advance();
    return boom;
  };
  const scene::BoomScene nominal = at(options.scene.percussion_nominal_bar),
                         half = at(options.scene.percussion_nominal_bar / 2);
  CHECK(half.impacts().mean_gap_samples / nominal.impacts().mean_gap_samples ==
        doctest::Approx(std::sqrt(2)));
  const double level_db = static_cast<double>(half.drill().slots[0].controls.mean_amplitude_db -
                                              nominal.drill().slots[0].controls.mean_amplitude_db);
  CHECK(level_db == doctest::Approx(-3.01).epsilon(0.01));
}

TEST_CASE("a rig at rest follows a new rate, pressure or control in the next chunk") {
  const SoundSet sounds = tools::formula_sounds();
  scene::BoomScene boom(tools::full_options(), sounds, 0);
  BoomState state;
  state.feed_pressure_bar = 110;
  state.percussion_rate_hz = 30;
  boom.set(state);
  for (int i = 0; i < 5000; ++i) boom.advance();
  const double gap = boom.impacts().mean_gap_samples;
  const double db = static_cast<double>(boom.drill().slots[0].controls.mean_amplitude_db);
  state.percussion_rate_hz = 60;
  state.controls.decay_factor = 2;
  state.percussion_pressure_bar = static_cast<float>(2 * EngineOptions{}.scene.percussion_nominal_bar);
  boom.set(state);
  boom.advance();
  CHECK(boom.impacts().mean_gap_samples == doctest::Approx(gap / 2));
  CHECK(boom.drill().slots[0].controls.decay_factor == 2);
  CHECK(static_cast<double>(boom.drill().slots[0].controls.mean_amplitude_db) - db ==
        doctest::Approx(10 * std::log10(2)).epsilon(1e-4));
}

TEST_CASE("a steady rig is placed once, not every chunk") {
  const SoundSet sounds = tools::formula_sounds();
  scene::BoomScene boom(tools::full_options(), sounds, 0);
  BoomState state;
  state.feed_pressure_bar = 110;
  boom.set(state);
  for (int i = 0; i < 5000; ++i) boom.advance();
  const drill::BankChoices before = boom.drill().slots[0].banks;
  boom.advance();
  CHECK(boom.drill().slots[0].banks.choice[0].share == before.choice[0].share);
  CHECK(before.choice[1].share == doctest::Approx(20.0 / 60));  // arrived, not nearly so
}

namespace {

std::vector<float> played(Engine& engine, const MachineState& state, int blocks) {
  std::vector<float> pcm, block(engine.options().block * engine.options().channels);
  for (int i = 0; i < blocks; ++i) {
    engine.process(state, block.data());
    pcm.insert(pcm.end(), block.begin(), block.end());
  }
  return pcm;
}

bool silent(const std::vector<float>& pcm) {
  for (const float x : pcm)
    if (x != 0) return false;
  return true;
}

}  // namespace

TEST_CASE("freeze: the sound fades, time stands still, and run goes on from the same state") {
  const EngineOptions options = tools::full_options();
  Engine paused(options, tools::formula_sounds()), straight(options, tools::formula_sounds());
  MachineState state = tools::drilled_hole(20);
  MachineState frozen = state;
  frozen.simulation = Simulation::kFreeze;
  played(paused, state, 1000), played(straight, state, 1000);
  const std::vector<float> fading = played(paused, frozen, 300);  // 0.4 s
  CHECK_FALSE(silent(fading));
  CHECK(silent(played(paused, frozen, 5000)));
  // The straight one goes on for as long as the fade took; from there on both are the same once the level is
  // back.
  int fade_blocks = 0;
  for (std::size_t n = 0; n < fading.size(); ++n)
    if (fading[n] != 0) fade_blocks = static_cast<int>(n / (options.block * options.channels)) + 1;
  MachineState muted = state;
  muted.output_gain = 0;
  played(straight, muted, fade_blocks);
  const std::vector<float> a = played(paused, state, 2000);
  CHECK_FALSE(silent(a));
}

TEST_CASE("reset: the scene starts anew, bit for bit as a new engine") {
  const EngineOptions options = tools::full_options();
  Engine used(options, tools::formula_sounds()), fresh(options, tools::formula_sounds());
  const MachineState state = tools::drilled_hole(20);
  MachineState reset = state;
  reset.simulation = Simulation::kReset;
  played(used, state, 1500);
  played(used, reset, 500);
  CHECK(played(used, state, 1500) == played(fresh, state, 1500));
}

TEST_CASE("a rod that breaks is heard once, loud, and then strikes air until it is whole again") {
  EngineOptions options;
  options.mix.ceiling_dbfs = 0;
  options.mix.drill_db = -20;
  SoundSet sounds = tools::formula_sounds();
  sounds.diesels.clear();
  Engine engine(options, sounds);
  MachineState state;
  state.boom[0].feed_pressure_bar = 150;
  const auto peak = [](const std::vector<float>& pcm) {
    float most = 0;
    for (const float x : pcm) most = std::max(most, std::fabs(x));
    return static_cast<double>(most);
  };
  const double drilling = peak(played(engine, state, 1500));
  state.boom[0].rod_broken = RodBroken::kYes;
  CHECK(peak(played(engine, state, 20)) > 2 * drilling);  // the snap
  played(engine, state, 750);
  const std::vector<float> air = played(engine, state, 750);
  CHECK_FALSE(silent(air));
  state.boom[0].feed_pressure_bar = 0;  // a parted string cannot feel the feed: the same sound goes on
  CHECK(peak(played(engine, state, 750)) < 2 * peak(air));
}

namespace {

/// Formula sounds with a drill string on the first boom; two rocks.
struct Strung {
  Strung() : sounds(tools::formula_sounds()) {
    sounds.diesels.clear();
    sounds.strings.emplace_back();
    sounds.rocks = {{"soft", 5e7}, {"hard", 2e9}};
    options.booms[0].drill_string = 0;
    options.mix.drill_db = -60;
    options.mix.tool_db = 0;
  }
  std::vector<float> play(const MachineState& state, int blocks = 1500) const {
    Engine engine(options, sounds);
    return played(engine, state, blocks);
  }
  SoundSet sounds;
  EngineOptions options;
};

}  // namespace

TEST_CASE(
    "rods, rock and the rod's place in the hole are in the sound of a drill string, and reset begins it "
    "anew") {
  const Strung strung;
  MachineState state;
  state.boom[0].feed_pressure_bar = 90;
  const std::vector<float> one = strung.play(state);
  CHECK_FALSE(silent(one));
  MachineState other = state;
  other.boom[0].rod_count = 6;
  CHECK(strung.play(other) != one);
  other = state, other.boom[0].rock = 1;
  CHECK(strung.play(other) != one);
  other = state, other.boom[0].feed_position_m = 3;
  CHECK(strung.play(other) != one);

  Engine used(strung.options, strung.sounds), fresh(strung.options, strung.sounds);
  MachineState reset = state;
  reset.simulation = Simulation::kReset;
  other.boom[0].rod_count = 3;
  played(used, other, 1000), played(used, reset, 500);
  CHECK(played(used, state, 1000) == played(fresh, state, 1000));
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
