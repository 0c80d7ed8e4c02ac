// What the engine says of itself is what it did.
#include "rigsound/engine_view.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "impact/rate_counter.hpp"
#include "mix/level_meter.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

namespace {

/// An engine that is told one state at a time.
struct Playing {
  explicit Playing(const EngineOptions& options, const SoundSet& sounds = tools::formula_sounds())
      : engine(options, sounds), block(static_cast<std::size_t>(options.block * options.channels)) {}

  /// `each(view, block)` after every block.
  template <class Each>
  void run(const MachineState& state, double seconds, Each each) {
    const EngineOptions& o = engine.options();
    for (int i = 0; i < seconds * o.sample_rate / o.block; ++i) {
      engine.process(state, block.data());
      each(engine.view(), block);
    }
  }
  const EngineView& run(const MachineState& state, double seconds) {
    run(state, seconds, [](const EngineView&, const std::vector<float>&) {});
    return engine.view();
  }

  Engine engine;
  std::vector<float> block;
};

MachineState fed(double bar) {
  MachineState state;
  state.boom[0].feed_pressure_bar = static_cast<float>(bar);
  return state;
}

double share_of(const BoomView& view, int bank) {
  double share = 0;
  for (int i = 0; i < view.bank_count; ++i) share += view.banks[i].bank == bank ? view.banks[i].share : 0.0F;
  return share;
}

double total_share(const BoomView& view) {
  double total = 0;
  for (int i = 0; i < view.bank_count; ++i) total += static_cast<double>(view.banks[i].share);
  return total;
}

}  // namespace

TEST_CASE("a view names the situation, how far it is from normal, and the banks by their shares") {
  Playing playing(tools::full_options());  // normal stands at 90 bar, overfeed at 150
  const BoomView at_105 = playing.run(fed(105), 2).boom[0];
  CHECK(at_105.situation == Situation::kNormal);
  CHECK(at_105.hammering);
  CHECK(at_105.feed_deviation == doctest::Approx(0.25).epsilon(0.01));
  CHECK(share_of(at_105, 0) == doctest::Approx(0.75).epsilon(0.01));
  CHECK(share_of(at_105, 2) == doctest::Approx(0.25).epsilon(0.01));
  const BoomView at_240 = playing.run(fed(240), 2).boom[0];
  CHECK(at_240.situation == Situation::kOverfeed);
  CHECK(at_240.feed_deviation == doctest::Approx(2.5).epsilon(0.01));
  CHECK(share_of(at_240, 2) == doctest::Approx(1));
  MachineState off = fed(240);
  off.boom[0].percussion = Percussion::kOff;
  const BoomView resting = playing.run(off, 2).boom[0];
  CHECK_FALSE(resting.hammering);
  CHECK(resting.impact_rate_hz == 0);
  CHECK(resting.impacts_made_hz == 0);
}

TEST_CASE("shares add up to one all the way through a crossfade") {
  Playing playing(tools::full_options());
  playing.run(fed(105), 1);
  MachineState rattling = fed(105);
  rattling.boom[0].rattling = Rattling::kOpen;
  double least_open = 1;
  playing.run(rattling, 0.3, [&](const EngineView& view, const std::vector<float>&) {
    REQUIRE(total_share(view.boom[0]) == doctest::Approx(1));
    least_open = std::min(least_open, share_of(view.boom[0], 4));
  });
  CHECK(least_open < 0.1);  // it was seen on its way
  CHECK(share_of(playing.engine.view().boom[0], 4) == doctest::Approx(1));
}

TEST_CASE("rods and rock asked for stand beside those of the banks") {
  SoundSet sounds = tools::formula_sounds();
  sounds.rocks = {{"granite"}, {"marble"}};
  for (BankUse& use : sounds.uses) use.rods = 6, use.rock = 1;
  Playing playing(tools::full_options(), sounds);
  MachineState state = fed(90);
  state.boom[0].rod_count = 20;
  state.boom[0].rock = 0;
  const BoomView view = playing.run(state, 2).boom[0];
  CHECK(view.rods == 20);
  CHECK(view.rock == 0);
  REQUIRE(view.bank_count > 0);
  CHECK(view.banks[0].rods == 6);
  CHECK(view.banks[0].rock == 1);
}

TEST_CASE("the rate asked for is the one made, as far as a second of impacts can tell") {
  SoundSet sounds = tools::formula_sounds();
  for (ClickBank& bank : sounds.banks) bank.miss_share = 0, bank.gap_deviation_samples = 0;
  Playing playing(tools::full_options(), sounds);
  for (const float rate : {12.0F, 40.0F, 100.0F}) {
    MachineState state = fed(90);
    state.boom[0].percussion_rate_hz = rate;
    const BoomView view = playing.run(state, 2.5).boom[0];
    CHECK(view.impact_rate_hz == doctest::Approx(rate));
    CHECK(std::fabs(view.impacts_made_hz - rate) < 1.2F);
  }
}

TEST_CASE("a counter's second moves on: what is older is forgotten") {
  impact::RateCounter counter(48000);
  CHECK(counter.rate_hz() == 0);
  for (int chunk = 0; chunk < 750; ++chunk) counter.add(chunk % 30 == 0 ? 1 : 0);  // half a second at 50 Hz
  CHECK(counter.rate_hz() == doctest::Approx(50));
  for (int chunk = 0; chunk < 1500; ++chunk) counter.add(chunk % 15 == 0 ? 1 : 0);  // a second at 100 Hz
  CHECK(counter.rate_hz() == doctest::Approx(100).epsilon(0.02));
  for (int chunk = 0; chunk < 1700; ++chunk) counter.add(0);
  CHECK(counter.rate_hz() == 0);
}

TEST_CASE("the meter's peak and rms are those of the samples") {
  std::vector<double> x(static_cast<std::size_t>(2 * kChunk));
  double peak = 0, energy = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = std::sin(0.7 * static_cast<double>(n)) * (n == 41 ? -3 : 1);
    peak = std::max(peak, std::fabs(x[n]));
    energy += x[n] * x[n];
  }
  mix::LevelMeter meter;
  meter.add(x.data(), kChunk);
  meter.add(x.data() + kChunk, kChunk);
  const LayerLevel level = meter.take(0.5, 2 * kChunk);
  CHECK(level.peak == doctest::Approx(0.5 * peak));
  CHECK(level.rms == doctest::Approx(0.5 * std::sqrt(energy / (2 * kChunk))));
  CHECK(meter.take(1, kChunk).peak == 0);
}

TEST_CASE("a layer that sounds alone has the level of the output") {
  EngineOptions options = tools::full_options();
  options.channels = 1;
  options.booms = {{"boom", 0, -9, -1}};
  options.mix.equaliser.clear();
  options.mix.drill_db = -15;
  SoundSet sounds = tools::formula_sounds();
  sounds.diesels.clear();
  Playing playing(options, sounds);
  double heard = 0, told = 0;
  float heard_peak = 0, told_peak = 0;
  playing.run(fed(90), 4, [&](const EngineView& view, const std::vector<float>& block) {
    for (const float x : block) heard += static_cast<double>(x) * static_cast<double>(x);
    for (const float x : block) heard_peak = std::max(heard_peak, std::fabs(x));
    const auto rms = static_cast<double>(view.boom[0].drill.rms);
    told += rms * rms * static_cast<double>(block.size());
    told_peak = std::max(told_peak, view.boom[0].drill.peak);
    REQUIRE(view.diesel.peak == 0);
    REQUIRE(view.boom[0].tool.peak == 0);
  });
  CHECK(heard > 0);
  CHECK(told == doctest::Approx(heard).scale(0).epsilon(0.02));
  CHECK(told_peak == doctest::Approx(heard_peak).scale(0).epsilon(0.01));
}

TEST_CASE("a paused simulator's layers are silent, and the view says that time stands still") {
  Playing playing(tools::full_options());
  MachineState state = fed(90);
  state.engine_rpm = 1500;
  CHECK_FALSE(playing.run(state, 1).stands_still);
  state.simulation = Simulation::kFreeze;
  const EngineView view = playing.run(state, 2);
  CHECK(view.stands_still);
  CHECK(view.diesel.peak == 0);
  CHECK(view.boom[0].drill.peak == 0);
  CHECK(view.boom[0].situation == Situation::kNormal);
}
