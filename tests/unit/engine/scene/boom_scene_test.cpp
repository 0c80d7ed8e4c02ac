// What a boom's scene makes of rates, pressures and controls.
#include "scene/boom_scene.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bench/formula_sounds.hpp"
#include "impact/impact_train.hpp"

using namespace rigsound;

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
