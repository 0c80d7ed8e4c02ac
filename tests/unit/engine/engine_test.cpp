#include "rigsound/engine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "engine/allocation_guard.hpp"

using namespace rigsound;

namespace {

/// `seconds` of the drilled hole; the state changes only where `grid` frames divide.
std::vector<float> render(const EngineOptions& options, double seconds, int grid) {
  Engine engine(options, tools::formula_sounds(options.sample_rate));
  std::vector<float> pcm;
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  for (int frame = 0; frame < seconds * options.sample_rate; frame += options.block) {
    const int held = frame - frame % grid;
    engine.process(tools::drilled_hole(held / options.sample_rate + 7), block.data());
    pcm.insert(pcm.end(), block.begin(), block.end());
  }
  return pcm;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("same state, same sounds, same seed: same bits; another seed: others") {
  EngineOptions options = tools::full_options();
  const auto first = render(options, 4, 64);
  CHECK(same_bits(first, render(options, 4, 64)));
  options.seed += 1;
  CHECK_FALSE(same_bits(first, render(options, 4, 64)));
}

TEST_CASE("the block size does not matter while states change on the same frames") {
  const auto reference = render(tools::full_options(64), 12, 512);
  for (const int block : {32, 128, 256, 512}) {
    CAPTURE(block);
    CHECK(same_bits(reference, render(tools::full_options(block), 12, 512)));
  }
}

TEST_CASE("process never allocates, whatever the state") {
  const EngineOptions options = tools::full_options();
  Engine engine(options, tools::formula_sounds());
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  const long before = tests::allocations();
  for (int i = 0; i < 45000; ++i) engine.process(tools::drilled_hole(i * 64 / 48000.0), block.data());
  CHECK(tests::allocations() == before);
  CHECK(before > 0);  // the hook is in place: building the engine was counted
}

TEST_CASE("no state makes a sample exceed the ceiling or be anything but a number") {
  EngineOptions options = tools::full_options();
  options.mix.drill_db = 24;
  options.mix.ceiling_dbfs = -3;
  Engine engine(options, tools::formula_sounds());
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  const float ceiling = std::pow(10.0f, -3 / 20.0f) * 1.000001f;
  for (int i = 0; i < 20000; ++i) {
    MachineState state = tools::drilled_hole(i * 64 / 48000.0);
    if (i % 7 == 0) state.engine_rpm = NAN;
    if (i % 11 == 0) state.boom[0].feed_pressure_bar = -INFINITY;
    state.boom[0].controls.mean_amplitude_db = 500;
    engine.process(state, block.data());
    for (const float x : block) REQUIRE(std::fabs(x) <= ceiling);
  }
  CHECK(engine.meters().limiter_gain <= 1);
}

TEST_CASE("a muted rig falls silent, fully, and comes back") {
  const EngineOptions options = tools::full_options();
  Engine engine(options, tools::formula_sounds());
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  MachineState state = tools::drilled_hole(20);
  const auto run = [&](double seconds) {
    for (int i = 0; i < seconds * 750; ++i) engine.process(state, block.data());
    return engine.meters().peak;
  };
  CHECK(run(1) > 0.01f);
  state.output_gain = 0;
  CHECK(run(1) == 0);
  state.output_gain = 1;
  CHECK(run(1) > 0.01f);
}

TEST_CASE("all that the limiter still holds has been heard before a paused rig stands still") {
  EngineOptions options = tools::full_options();
  options.mix.lookahead_s = 0.02;
  options.mix.equaliser.push_back({40, 24, 20});  // rings for seconds
  Engine engine(options, tools::formula_sounds());
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  MachineState state = tools::drilled_hole(20);
  for (int i = 0; i < 750; ++i) engine.process(state, block.data());
  state.simulation = Simulation::kFreeze;
  while (!engine.view().stands_still) engine.process(state, block.data());
  for (int frames = 0; frames <= lookahead_frames(options); frames += options.block)
    engine.process(state, block.data());
  state.simulation = Simulation::kRun;
  state.output_gain = 0;
  for (int i = 0; i < 20; ++i) {
    engine.process(state, block.data());
    CHECK(engine.meters().peak == 0);
  }
}

TEST_CASE("with look-ahead it sounds the same, later, while nothing is near the ceiling") {
  EngineOptions options = tools::full_options();
  options.mix.drill_db = options.mix.tool_db = options.mix.diesel_db = -30;
  const auto ahead = render(options, 2, 64);
  const auto later = static_cast<std::size_t>(lookahead_frames(options) * options.channels);
  CHECK(later == 96 * 2);
  options.mix.lookahead_s = 0;
  const auto at_once = render(options, 2, 64);
  CHECK(std::equal(ahead.begin() + static_cast<std::ptrdiff_t>(later), ahead.end(), at_once.begin()));
  CHECK(*std::max_element(ahead.begin(), ahead.end()) > 0.001f);
}

TEST_CASE("the tool rings on the very sample of the click") {
  SoundSet sounds = tools::formula_sounds();
  EngineOptions options;
  options.booms = {{"boom", 0, 0, 0}};
  sounds.diesels.clear();
  MachineState state;
  state.boom[0].feed_pressure_bar = 90;
  const auto first_sound = [&](double drill_db, double tool_db) {
    options.mix.drill_db = drill_db, options.mix.tool_db = tool_db;
    Engine engine(options, sounds);
    std::vector<float> block(128);
    for (int frame = 0; frame < 48000; frame += 64) {
      engine.process(state, block.data());
      for (std::size_t n = 0; n < 64; ++n)
        if (std::fabs(block[2 * n]) > 1e-6f) return frame + static_cast<int>(n);
    }
    return -1;
  };
  const int click = first_sound(0, -60);
  const int ring = first_sound(-60, 24);
  CHECK(click >= 0);
  CHECK(std::abs(click - ring) <= 2);
}

TEST_CASE("options and sound sets that cannot work are refused by name") {
  const SoundSet sounds = tools::formula_sounds();
  const auto refused = [&sounds](auto change, const char* word) {
    EngineOptions options = tools::full_options();
    SoundSet set = sounds;
    change(options, set);
    CHECK_THROWS_WITH_AS(Engine(options, set), doctest::Contains(word), std::invalid_argument);
  };
  refused([](auto& o, auto&) { o.sample_rate = 0; }, "rate");
  refused([](auto& o, auto&) { o.block = 48; }, "block");
  refused([](auto& o, auto&) { o.channels = 9; }, "channels");
  refused([](auto& o, auto&) { o.booms.clear(); }, "booms");
  refused([](auto& o, auto&) { o.booms[0].tool = 3; }, "tool");
  refused([](auto& o, auto&) { o.scene.overfeed_bar = 10; }, "overfeed_bar");
  refused([](auto& o, auto&) { o.mix.ceiling_dbfs = 3; }, "ceiling_dbfs");
  refused([](auto& o, auto&) { o.scene.crossfade_s = 12; }, "scene.crossfade_s: is 12 s, expected 0...10 s");
  refused([](auto& o, auto&) { o.scene.contact_bar = 60; },
          "scene.contact_bar: is 60 bar, expected less than");
  refused([](auto& o, auto&) { o.booms[1].pan = -2; }, "boom[1].pan: is -2, expected -1...1");
  refused(
      [](auto& o, auto&) {
        o.mix.equaliser = {{22000, 0, 1}};
      },
      "mix.equaliser[0].frequency_hz: is 22000");
  refused([](auto&, auto& s) { s.uses.erase(s.uses.begin()); }, "normal");
  refused([](auto&, auto& s) { s.banks[2].sample_rate = 44100; }, "rate");
  refused([](auto&, auto& s) { s.uses[1].bank = -1; }, "bank: of a use is not there");
  refused([](auto&, auto& s) { s.uses[1].bank = static_cast<int>(s.banks.size()); },
          "bank: of a use is not there");
  refused([](auto& o, auto&) { o.booms[0].tool = -2; }, "boom.tool");
  refused([](auto& o, auto& s) { o.booms[0].drill_string = static_cast<int>(s.strings.size()); },
          "boom.tool");
  refused([](auto& o, auto&) { o.booms[0].drill_string = -2; }, "boom.tool");
}
