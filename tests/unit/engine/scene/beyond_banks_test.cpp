// What is heard beyond the outermost bank follows the laws: level, rate, decay and brightness.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"
#include "rigsound/machine/machine_state.hpp"

using namespace rigsound;

namespace {

/// Mean level of 20 s of drilling alone, dB.
double level_at(const SoundSet& sounds, double feed_bar) {
  EngineOptions options = tools::full_options();
  options.mix.tool_db = options.mix.diesel_db = -60;
  options.mix.ceiling_dbfs = 0, options.mix.drill_db = -20;
  Engine engine(options, sounds);
  MachineState state;
  state.boom[0].feed_pressure_bar = static_cast<float>(feed_bar);
  state.boom[0].percussion = Percussion::kOn;
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  double sum = 0;
  const int settle = 48000 / options.block, blocks = 20 * 48000 / options.block;
  for (int i = 0; i < settle + blocks; ++i) {
    engine.process(state, block.data());
    for (const float x : block) sum += i >= settle ? static_cast<double>(x) * static_cast<double>(x) : 0;
  }
  return 10 * std::log10(sum / blocks);
}

}  // namespace

TEST_CASE("beyond the outermost bank the level goes on by its law, though clicks get shorter and duller") {
  SoundSet sounds = tools::formula_sounds();
  FeedLaws laws;
  laws.ln_gap = 0.0011, laws.ln_level = 0.0035, laws.ln_decay = 0.008, laws.tilt_db_per_octave = -0.05;
  sounds.laws = {laws};
  const double at_bank = level_at(sounds, 150);
  for (const double beyond : {25.0, 50.0}) {
    CAPTURE(beyond);
    // The level is that of a blow's energy; as many fewer blows come.
    const double wanted = beyond * (laws.ln_level - 0.5 * laws.ln_gap) * 20 / std::log(10.0);
    // Some 800 blows of chance strength: their mean is good for a quarter of a dB.
    CHECK(std::fabs(level_at(sounds, 150 + beyond) - at_bank - wanted) < 0.25);
  }
}
