// Pause, reset, a broken rod and the hole's state, as an engine plays them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

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
