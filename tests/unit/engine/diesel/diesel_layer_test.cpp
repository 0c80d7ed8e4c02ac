// The run-time background against its formulas.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "diesel/diesel_layer.hpp"
#include "diesel/operating_grid.hpp"
#include "engine/allocation_guard.hpp"
#include "engine/diesel/bare_diesel.hpp"
#include "engine/diesel/diesel_measures.hpp"
#include "engine/diesel/played_diesel.hpp"
#include "engine/heard.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

TEST_CASE("an order sounds at its frequency and level, whatever the speed") {
  DieselModel model = bare_diesel(1200);
  model.points[0].orders.assign(12, {0, 0});
  model.points[0].orders[11] = {0.1F, 0.0F};
  for (const double rpm : {900.0, 1200.0}) {
    DieselLayer layer({model}, kRate, 1, 600);
    const std::vector<double> x = play(layer, {rpm, 0, 0}, 3);
    double re = 0, im = 0;
    for (std::size_t n = x.size() - 48000; n < x.size(); ++n) {
      const double angle = 2 * M_PI * 12 * rpm / 120 * static_cast<double>(n) / kRate;
      re += x[n] * std::cos(angle), im += x[n] * std::sin(angle);
    }
    CHECK(2 * std::hypot(re, im) / 48000 == doctest::Approx(0.1).epsilon(0.002));
    CHECK(power(x, x.size() - 48000) == doctest::Approx(0.005).scale(0).epsilon(0.004));  // and nothing else
  }
}

TEST_CASE("orders that would fold over fall silent") {
  DieselModel model = bare_diesel(800);
  model.angle_samples = 8192, model.slots = 128;
  model.points[0].slot_variance.assign(128 * (slot_band_edges(64).size() - 1), 0.0F);
  model.points[0].slot_log_variance.assign(128, 0.0F);
  model.points[0].orders.assign(1600, {0, 0});
  model.points[0].orders[1599] = {0.1F, 0.0F};  // 10.7 kHz at 800 r/min, 26.7 kHz at 2000
  DieselLayer layer({model}, kRate, 1, 600);
  CHECK(power(play(layer, {800, 0, 0}, 2), 48000) > 0.004);
  CHECK(power(play(layer, {2000, 0, 0}, 2), 48000) < 1e-9);
}

TEST_CASE("whatever the bus says, the voice neither clicks nor leaves the numbers") {
  const DieselModel model = default_diesel();
  const auto largest_step = [](const std::vector<double>& x) {
    double worst = 0;
    for (std::size_t n = 1; n < x.size(); ++n) worst = std::max(worst, std::fabs(x[n] - x[n - 1]));
    return worst;
  };
  DieselLayer calm({model}, kRate, 1, 800);
  double usual = 0;
  for (const double rpm : {800.0, 1500.0, 2500.0, 4000.0})
    usual = std::max(usual, largest_step(play(calm, {rpm, 1, 1}, 1)));
  DieselLayer wild({model}, kRate, 1, 800);
  const double jumps[][3] = {{4000, 0, 0}, {0, 1, 1},   {800, 0, 1},  {801, 1, 0},  {3999, 0, 1},
                             {20, 1, 0},   {0, 0, 0},   {1e-3, 1, 1}, {1500, 0, 0}, {0, 1, 1},
                             {4000, 1, 1}, {700, 0, 0}, {2300, 1, 0}, {300, 0, 1},  {900, 1, 1}};
  for (const double seconds : {0.002, 0.02, 0.1, 0.4, 1.5})
    for (const auto& jump : jumps) {
      const std::vector<double> x = play(wild, {jump[0], jump[1], jump[2]}, seconds);
      for (const double v : x) REQUIRE(std::isfinite(v));
      CHECK(largest_step(x) < 1.5 * usual);
    }
}

TEST_CASE("the same seed gives the same samples, another one others; the audio thread never allocates") {
  const DieselModel model = default_diesel();
  DieselLayer a({model}, kRate, 7, 800), b({model}, kRate, 7, 800), c({model}, kRate, 8, 800);
  const DieselInput controls{1500, 0.4, 0.6};
  const std::vector<double> x = play(a, controls, 1);
  CHECK(x == play(b, controls, 1));
  CHECK(x != play(c, controls, 1));
  double chunk[kChunk];
  const long before = tests::allocations();
  for (int i = 0; i < 20000; ++i) a.process({600.0 + 0.1 * i, 0.5, 0.2}, chunk);
  CHECK(tests::allocations() == before);
}

TEST_CASE("an engine that stands is silent, whatever the pressure") {
  DieselLayer layer({default_diesel()}, kRate, 1, 800);
  CHECK(power(play(layer, {0, 0, 1}, 0.5)) == 0);
  CHECK(power(play(layer, {800, 0, 0}, 2), 48000) > 1e-5);
  play(layer, {0, 0, 0}, 1);
  CHECK(power(play(layer, {0, 0, 0}, 0.5)) == 0);
}

TEST_CASE("hydraulics: pump and flow as loud as written, by the pressure to its exponent") {
  DieselModel model = bare_diesel(800);
  model.hydraulic.pump = {0.02F, 0.01F};
  model.hydraulic.flow = 0.03;
  model.hydraulic.flow_filter = {1.0F, -0.9F};
  DieselLayer layer({model}, kRate, 1, 800);
  const double full = power(play(layer, {800, 0, 1}, 8), 96000);
  CHECK(full == doctest::Approx(0.5 * (4e-4 + 1e-4) + 9e-4).scale(0).epsilon(0.03));
  const double half = power(play(layer, {800, 0, 0.5}, 8), 96000);
  CHECK(half / full == doctest::Approx(std::pow(0.5, 2 * 0.7)).epsilon(0.03));
}

TEST_CASE("the pump strokes at its order of the speed") {
  DieselModel model = bare_diesel(800);
  model.hydraulic.pump = {0.02F};
  DieselLayer layer({model}, kRate, 1, 800);
  const std::vector<double> x = play(layer, {1200, 0, 1}, 3);
  const auto near = [&](double hz) {  // mean power 4 Hz around: the line is 0.3 Hz wide
    double sum = 0;
    for (double f = hz - 4; f <= hz + 4; f += 1) {
      double re = 0, im = 0;
      for (std::size_t n = 48000; n < x.size(); ++n) {
        const double angle = 2 * M_PI * f * static_cast<double>(n) / kRate;
        re += x[n] * std::cos(angle), im += x[n] * std::sin(angle);
      }
      sum += re * re + im * im;
    }
    return sum;
  };
  CHECK(near(180) > 1000 * near(120));  // eighteen strokes in each of ten cycles a second
}

TEST_CASE("two points join in the order domain: level geometric, phase along the shorter way") {
  DieselModel model = bare_diesel(1000);
  model.points[0].orders = {{0.01F, 0.0F}};
  DieselPoint fast = model.points[0];
  fast.rpm = 2000;
  fast.orders = {std::polar(0.04F, 2.0F)};
  model.points.push_back(fast);
  const OperatingGrid grid(model, kRate);
  const double middle = std::sqrt(1000.0 * 2000.0);
  std::vector<double> table(static_cast<std::size_t>(model.angle_samples));
  grid.mix(grid.place(middle, 0), &OperatingState::table, 0, model.angle_samples, table.data());
  for (std::size_t n = 0; n < table.size(); n += 97)
    CHECK(table[n] ==
          doctest::Approx(0.02 * std::cos(2 * M_PI * static_cast<double>(n) / model.angle_samples + 1.0))
              .epsilon(0.001)
              .scale(0.02));
}

TEST_CASE("resampling through a ramp of 600 to 2400 r/min") {
  const tests::ResamplingError error = tests::resampling_error();
  CHECK(error.white_db <= -85);
  CHECK(error.engine_like_db <= -105);
}

TEST_CASE("rpm tracker on 20 ms messages: a ramp of 900 r/min a second, steps of 0.125") {
  const tests::TrackerError error = tests::tracker_error();
  CHECK(error.settled_cents <= 1);
  CHECK(error.ramp_cents <= 8);
  CHECK(error.overshoot_cents <= 20);
}

TEST_CASE("an all-pole body keeps its response at another sampling rate") {
  std::vector<double> r(17);
  for (std::size_t lag = 0; lag < r.size(); ++lag)
    r[lag] = std::pow(0.97, lag) * std::cos(0.2 * static_cast<double>(lag)) + (lag == 0 ? 0.01 : 0.0);
  const std::vector<double> a = dsp::levinson(r).a, b = dsp::all_pole_at_rate(a, 48000, 44100);
  const auto db = [](const std::vector<double>& c, double f, double rate) {
    double re = 0, im = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      re += c[k] * std::cos(2 * M_PI * f / rate * static_cast<double>(k));
      im += c[k] * std::sin(2 * M_PI * f / rate * static_cast<double>(k));
    }
    return -10 * std::log10(re * re + im * im);
  };
  const double offset = db(b, 1500, 44100) - db(a, 1500, 48000);
  for (const double f : {300.0, 1000.0, 3000.0, 8000.0, 15000.0})
    CHECK(std::fabs(db(b, f, 44100) - db(a, f, 48000) - offset) < 1.0);
}

TEST_CASE("a speed extrapolated beyond the signal's range is heard as its end") {
  DieselLayer at_end({default_diesel()}, kRate, 1, 800), beyond({default_diesel()}, kRate, 1, 800);
  CHECK(play(at_end, {4000, 0.5, 0.5}, 1.5) == play(beyond, {5500, 0.5, 0.5}, 1.5));
}

TEST_CASE("with points of one load the level follows the load by the slope") {
  DieselModel model = bare_diesel(1200);
  model.points[0].load = 0.25;
  model.points[0].orders = {{0.1F, 0.0F}};
  model.load_slope_db = 8;
  const auto level_db = [&](double load) {
    DieselLayer layer({model}, kRate, 1, 600);
    return 10 * std::log10(power(play(layer, {1200, load, 0}, 2), 48000));
  };
  const double at_point = level_db(0.25);
  CHECK(at_point == doctest::Approx(10 * std::log10(0.005)).epsilon(0.001));
  CHECK(level_db(1) - at_point == doctest::Approx(6).epsilon(0.001));
  CHECK(level_db(0) - at_point == doctest::Approx(-2).epsilon(0.001));
}

TEST_CASE("a load that leaps is followed over a chunk, not at once") {
  struct Case {
    std::vector<double> loads;  // of points in turn soft and loud
    double leap_to, amplitude;  // what it is there
  };
  // To another point, to one beside it, past one, and to where the neighbours are the same two: a third of
  // the way, a tenth less.
  for (const Case& c : {Case{{0, 1}, 1, 0.4},
                        {{0, 0.5, 1}, 0.5, 0.4},
                        {{0, 1, 0.5}, 1, 0.4},
                        {{0, 1}, 0.3, 0.1 + 0.9 * (0.1 * std::cbrt(4) - 0.1)}}) {
    DieselModel model = bare_diesel(1200);
    model.points.clear();
    for (const double load : c.loads) {
      model.points.push_back(bare_diesel(1200).points[0]);
      model.points.back().load = load;
      model.points.back().orders.assign(6, {0, 0});
      model.points.back().orders[5] = {model.points.size() % 2 == 0 ? 0.4F : 0.1F, 0.0F};
    }
    DieselLayer layer({model}, kRate, 1, 600);
    play(layer, {1200, 0, 0}, 2);
    std::vector<double> x;
    for (int leap = 0; leap < 40; ++leap) {
      const std::vector<double> some = play(layer, {1200, leap % 2 == 0 ? c.leap_to : 0.0, 0}, 0.0037);
      x.insert(x.end(), some.begin(), some.end());
    }
    double steepest = 0;
    for (std::size_t n = 1; n < x.size(); ++n) steepest = std::max(steepest, std::fabs(x[n] - x[n - 1]));
    // The fade covers the interpolator's taps as well, so a tenth of the leap is left to either end of a
    // chunk.
    CAPTURE(c.loads.size());
    CAPTURE(c.leap_to);
    CHECK(steepest < 0.25 * (c.amplitude - 0.1));
  }
}

TEST_CASE("a copied layer goes on as its original would, also over one that played something else") {
  const DieselModel model = default_diesel();
  DieselLayer layer({model}, kRate, 1, 800), other({model}, kRate, 1, 800), none({}, kRate, 1, 800);
  play(layer, {900, 0.2, 0.3}, 1);
  DieselLayer copy(layer);
  other = layer;
  none = layer;  // has no voice to take it
  const std::vector<double> x = play(layer, {1500, 0.7, 0.1}, 0.3);
  CHECK(play(copy, {1500, 0.7, 0.1}, 0.3) == x);
  CHECK(play(other, {1500, 0.7, 0.1}, 0.3) == x);
  CHECK(power(play(none, {1500, 0.7, 0.1}, 0.1)) == 0);
  other = none;
  CHECK(power(play(other, {1500, 0.7, 0.1}, 0.3)) > 0);
}
