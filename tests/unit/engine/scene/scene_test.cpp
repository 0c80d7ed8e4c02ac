#include <doctest/doctest.h>

#include <cmath>

#include "bench/formula_sounds.hpp"
#include "rigsound/feed_rule.hpp"
#include "rigsound/machine/state_guard.hpp"
#include "scene/bank_choice.hpp"
#include "scene/boom_scene.hpp"
#include "scene/rig_scene.hpp"

using namespace rigsound;

namespace {

BoomState fed(double bar, Rattling rattling = Rattling::kNone) {
  BoomState state;
  state.feed_pressure_bar = static_cast<float>(bar);
  state.rattling = rattling;
  return state;
}

}  // namespace

TEST_CASE("feed pressure decides the situation, with hysteresis around each threshold") {
  SceneOptions options;  // underfeed below 60, overfeed above 120, band 6
  scene::FeedRule rule(options);
  const auto at = [&rule](double bar) {
    rule.update(fed(bar));
    return rule.situation();
  };
  CHECK(at(30) == Situation::kUnderfeed);
  CHECK(at(62) == Situation::kUnderfeed);
  CHECK(at(64) == Situation::kNormal);
  CHECK(at(58) == Situation::kNormal);
  CHECK(at(56) == Situation::kUnderfeed);
  CHECK(at(122) == Situation::kNormal);
  CHECK(at(124) == Situation::kOverfeed);
  CHECK(at(118) == Situation::kOverfeed);
  CHECK(at(116) == Situation::kNormal);
}

TEST_CASE("percussion follows contact and rattling when no bus reports it, and the bus when one does") {
  scene::FeedRule rule(SceneOptions{});
  rule.update(fed(5));
  CHECK_FALSE(rule.hammering());
  rule.update(fed(30));
  CHECK(rule.hammering());
  rule.update(fed(0, Rattling::kClosed));
  CHECK(rule.hammering());
  CHECK(rule.situation() == Situation::kClosedRattling);
  BoomState off = fed(100);
  off.percussion = Percussion::kOff;
  rule.update(off);
  CHECK_FALSE(rule.hammering());
}

TEST_CASE("the bank with the right rock and the nearest rod count is chosen") {
  SoundSet sounds;
  for (int i = 0; i < 5; ++i) sounds.banks.emplace_back();
  sounds.uses = {{Situation::kNormal, 1, -1, 0},
                 {Situation::kNormal, 6, -1, 1},
                 {Situation::kNormal, 1, 2, 2},
                 {Situation::kNormal, 0, 3, 3},
                 {Situation::kOverfeed, 0, -1, 4}};
  const auto chosen = [&sounds](Situation s, int rods, int rock) {
    const BankUse* use = scene::choose_bank(sounds, s, rods, rock);
    return use ? use->bank : -1;
  };
  CHECK(chosen(Situation::kNormal, 2, 0) == 0);
  CHECK(chosen(Situation::kNormal, 5, 0) == 1);
  CHECK(chosen(Situation::kNormal, 8, 2) == 2);
  CHECK(chosen(Situation::kNormal, 8, 3) == 3);
  CHECK(chosen(Situation::kOverfeed, 8, 3) == 4);
  CHECK(chosen(Situation::kUnderfeed, 1, 0) == -1);
}

TEST_CASE("a crossfade has equal power at every chunk and takes crossfade_s") {
  const SoundSet sounds = tools::formula_sounds();
  const EngineOptions options = tools::full_options();
  scene::BoomScene boom(options, sounds, 0);
  boom.set(fed(90));
  for (int i = 0; i < 1000; ++i) boom.advance();
  boom.set(fed(90, Rattling::kClosed));
  const int chunks = static_cast<int>(std::ceil(options.scene.crossfade_s * options.sample_rate / kChunk));
  for (int i = 0; i < chunks; ++i) {
    boom.advance();
    double power = 0;
    for (const drill::Slot& slot : boom.drill().slots) power += slot.gain.to * slot.gain.to;
    REQUIRE(power == doctest::Approx(1).epsilon(1e-9));
  }
  CHECK(boom.drill().slots[1].gain.to == doctest::Approx(1));
  CHECK(boom.drill().slots[0].gain.to == doctest::Approx(0));
  CHECK(boom.impacts().mean_gap_samples == doctest::Approx(sounds.banks[3].mean_gap_samples));
}

TEST_CASE("open rattling starts with its burst and settles") {
  const SoundSet sounds = tools::formula_sounds();
  const EngineOptions options = tools::full_options();
  scene::BoomScene boom(options, sounds, 0);
  boom.set(fed(0, Rattling::kOpen));
  const auto gain_after = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * options.sample_rate / kChunk); ++i) boom.advance();
    return boom.drill().slots[2].gain.to;
  };
  CHECK(gain_after(0.5) == doctest::Approx(1));
  CHECK(gain_after(1.5) ==
        doctest::Approx(std::pow(10, options.scene.open_sustain_db / 20)).scale(0).epsilon(0.01));
  boom.set(fed(0));
  gain_after(0.5);
  boom.set(fed(0, Rattling::kOpen));
  CHECK(gain_after(0.5) == doctest::Approx(1));
}

TEST_CASE("of the rod what is not in the hole is exposed, half of it where no bus says how far it is in") {
  SoundSet sounds = tools::formula_sounds();
  sounds.strings = {StringModel{}};
  EngineOptions options = tools::full_options();
  options.booms[0].drill_string = 0;
  scene::BoomScene boom(options, sounds, 0);
  const double rod_m = sounds.strings[0].rod_length_m;
  const auto exposed_m = [&](double in_hole_m) {
    BoomState state = fed(90);
    state.feed_position_m = static_cast<float>(in_hole_m);
    boom.set(state);
    boom.advance();
    return boom.rods().exposed_m;
  };
  CHECK(exposed_m(-1) == doctest::Approx(rod_m / 2));
  CHECK(exposed_m(0) == doctest::Approx(rod_m));
  CHECK(exposed_m(3) == doctest::Approx(rod_m - 3));
  CHECK(exposed_m(rod_m + 0.5) == 0);
}

TEST_CASE("nonsense from outside is brought into range") {
  MachineState state;
  state.engine_rpm = std::nanf("");
  state.output_gain = std::nanf("");
  state.master_gain_db = 40;
  state.boom[0].feed_pressure_bar = 1e30f;
  state.boom[0].controls.decay_factor = -INFINITY;
  state.boom[0].controls.mean_frequency_hz = std::nanf("");
  const MachineState safe = guarded(state);
  CHECK(safe.engine_rpm == 0);
  CHECK(safe.output_gain == 0);
  CHECK(safe.master_gain_db == 0);
  CHECK(safe.boom[0].feed_pressure_bar == 300);
  CHECK(safe.boom[0].controls.decay_factor == 0.25f);
  CHECK(safe.boom[0].controls.mean_frequency_hz == 0);
}

TEST_CASE("the output level arrives where it is asked to, within a second, and rests there") {
  scene::RigScene rig(EngineOptions{});
  for (const float gain : {1.0F, 0.25F, 0.0F, 0.7F}) {
    CAPTURE(gain);
    MachineState state;
    state.output_gain = gain;
    rig.set(state, 1, 0);
    rig.advance();
    CHECK_FALSE(rig.gain().rests_at(static_cast<double>(gain)));
    for (int n = 0; n < 48000 / kChunk; ++n) rig.advance();
    CHECK(rig.gain().rests_at(static_cast<double>(gain)));
  }
}
