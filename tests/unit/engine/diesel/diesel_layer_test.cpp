// The run-time background against its formulas.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "diesel/diesel_layer.hpp"
#include "diesel/slot_source.hpp"
#include "diesel/wavelet_tree.hpp"
#include "engine/allocation_guard.hpp"
#include "engine/diesel/bare_diesel.hpp"
#include "engine/diesel/diesel_measures.hpp"
#include "engine/heard.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

std::vector<double> play(DieselLayer& layer, const DieselInput& controls, double seconds) {
  std::vector<double> out(static_cast<std::size_t>(seconds * kRate / kChunk) * kChunk);
  for (std::size_t n = 0; n < out.size(); n += kChunk) layer.process(controls, &out[n]);
  return out;
}

double power(const std::vector<double>& x, std::size_t from = 0) {
  double sum = 0;
  for (std::size_t n = from; n < x.size(); ++n) sum += x[n] * x[n];
  return sum / static_cast<double>(x.size() - from);
}

}  // namespace

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

TEST_CASE("recorded start and stop play once each") {
  DieselModel model = bare_diesel(800);
  model.start.assign(24000, 0.25F);
  model.stop.assign(12000, -0.125F);
  DieselLayer layer({model}, kRate, 1, 800);
  const auto sum = [](const std::vector<double>& x) {
    double s = 0;
    for (const double v : x) s += v;
    return s;
  };
  CHECK(sum(play(layer, {800, 0, 0}, 3)) == doctest::Approx(6000));
  CHECK(sum(play(layer, {0, 0, 0}, 3)) == doctest::Approx(-1500));
}

TEST_CASE("the running engine comes in 0.3 s before the end of a recorded start, and not before") {
  DieselModel model = bare_diesel(800);
  model.points[0].orders.assign(12, {0, 0});
  model.points[0].orders[11] = {0.1F, 0.0F};  // 80 Hz
  model.start.assign(48000, 0.0F);
  DieselLayer layer({model}, kRate, 1, 800);
  const std::vector<double> x = play(layer, {800, 0, 0}, 2);
  std::size_t begins = 0;
  while (begins < x.size() && x[begins] == 0) ++begins;
  CHECK(static_cast<double>(begins) / kRate >= 0.7);
  CHECK(static_cast<double>(begins) / kRate < 0.8);  // the crank turns after a moment
  // Gained with 40 ms.
  const auto amplitude = [&](double from_s) {
    double most = 0;
    for (auto n = static_cast<std::size_t>(from_s * kRate);
         n < static_cast<std::size_t>((from_s + 0.0125) * kRate); ++n)
      most = std::max(most, std::fabs(x[n]));
    return most;
  };
  const double first_s = static_cast<double>(begins) / kRate;
  CHECK(amplitude(first_s + 0.0275) ==
        doctest::Approx(0.1 * (1 - std::exp(-0.04 / 0.04))).scale(0).epsilon(0.1));
  CHECK(amplitude(first_s + 0.3) == doctest::Approx(0.1).scale(0).epsilon(0.01));
}

TEST_CASE("a recorded start sounds alike at every rate, without what lies above half of it") {
  const auto energy_s = [](double hz, double rate) {
    DieselModel model = bare_diesel(800);
    for (int n = 0; n < 24000; ++n)
      model.start.push_back(static_cast<float>(0.25 * std::sin(2 * M_PI * hz * n / model.sample_rate)));
    DieselLayer layer({model}, rate, 1, 800);
    const std::vector<double> x = play(layer, {800, 0, 0}, 3);
    return power(x) * static_cast<double>(x.size()) / rate;
  };
  const double whole = 0.5 * 0.25 * 0.25 * 0.5;
  for (const double rate : {32000.0, 48000.0, 96000.0})
    CHECK(energy_s(5000, rate) == doctest::Approx(whole).scale(0).epsilon(0.005));
  CHECK(energy_s(20000, 32000) < 1e-3 * whole);
}

TEST_CASE("a one-shot that is overtaken fades away") {
  DieselModel model = bare_diesel(800);
  model.start.assign(48000, 0.25F);
  model.stop.assign(48000, -0.125F);
  DieselLayer layer({model}, kRate, 1, 800);
  const auto steps_of = [](const std::vector<double>& x) {
    double worst = 0;
    for (std::size_t n = 1; n < x.size(); ++n) worst = std::max(worst, std::fabs(x[n] - x[n - 1]));
    return worst;
  };
  play(layer, {100, 0, 0}, 0.3);  // cranked, and it does not catch
  const std::vector<double> gave_up = play(layer, {0, 0, 0}, 0.5);
  CHECK(steps_of(gave_up) < 0.001);
  CHECK(gave_up.back() == 0);
  play(layer, {800, 0, 0}, 3);
  play(layer, {0, 0, 0}, 0.4);  // dying, and started again
  const std::vector<double> again = play(layer, {800, 0, 0}, 0.5);
  CHECK(again.back() == doctest::Approx(0.25));
  CHECK(steps_of(again) < 0.3);  // the start may begin as it likes, the stop's end is smooth
}

TEST_CASE("a wavelet tree with equal deviations is white, each scale brings its share") {
  constexpr int kChannels = 64, kFrames = 4096;
  for (int N : {1, 2, 3}) {
    for (int scale = 0; scale <= N + 1; ++scale) {  // N + 1: all of them
      constexpr int kWidth = kChannels / WaveletTree::kGroups;
      std::vector<double> deviation(static_cast<std::size_t>((N + 1) * kWidth), 0.0);
      for (std::size_t i = 0; i < deviation.size(); ++i)
        deviation[i] = scale == N + 1 || static_cast<int>(i) / kWidth == scale;
      WaveletTree tree(kChannels, N, 5);
      double energy = 0, neighbour = 0;
      std::vector<double> last(kChannels, 0.0), now(kChannels);
      for (int frame = 0; frame < kFrames; ++frame) {
        for (int g = 0; g < WaveletTree::kGroups; ++g)
          tree.produce(g, deviation.data(),
                       &now[static_cast<std::size_t>(g * kChannels / WaveletTree::kGroups)]);
        for (std::size_t i = 0; i < now.size(); ++i) energy += now[i] * now[i], neighbour += now[i] * last[i];
        last = now;
      }
      const double share = scale == N + 1 ? 1.0 : scale == N ? std::pow(0.5, N) : std::pow(0.5, scale + 1);
      CAPTURE(N);
      CAPTURE(scale);
      CHECK(energy / (kFrames * kChannels) == doctest::Approx(share).epsilon(0.03));
      if (scale == N + 1) CHECK(std::fabs(neighbour / energy) < 0.01);
    }
  }
}

TEST_CASE("slots give the variance they were told, slot by slot") {
  DieselModel model = bare_diesel(1200);
  const std::size_t bands = slot_band_edges(model.slot_samples()).size() - 1;
  for (std::size_t l = 0; l < 64; ++l)
    for (std::size_t b = 0; b < bands; ++b)
      model.points[0].slot_variance[l * bands + b] = l % 16 < 4 ? 4.0F : 1.0F;
  const OperatingGrid grid(model, kRate);
  SlotSource source(model, kRate, 3);
  std::vector<double> slot(static_cast<std::size_t>(model.slot_samples()));
  double loud = 0, soft = 0;
  for (int frame = 0; frame < 64 * 200; ++frame) {
    source.produce(grid, grid.place(1200, 0), 10, slot.data());
    // Hop c lies under frames c and c + 1: loud throughout for c = 0, 1, 2, soft for 4 ... 14.
    if (frame % 16 < 3) loud += power(slot) / 2400;
    if (frame % 16 >= 4 && frame % 16 < 15) soft += power(slot) / 8800;
  }
  CHECK(loud == doctest::Approx(4.0).epsilon(0.03));
  CHECK(soft == doctest::Approx(1.0).epsilon(0.03));
}

TEST_CASE("slots that vary have on average the power they were told, and neighbours vary as they are told") {
  DieselModel model = bare_diesel(1200);
  DieselPoint& p = model.points[0];
  p.slot_variance.assign(p.slot_variance.size(), 1.0F);
  const auto measured = [&](double log_variance, double correlation) {
    p.slot_log_variance.assign(64, static_cast<float>(log_variance));
    p.slot_correlation = correlation;
    const OperatingGrid grid(model, kRate);
    SlotSource source(model, kRate, 3);
    std::vector<double> slot(static_cast<std::size_t>(model.slot_samples()));
    double mean = 0, square = 0, product = 0, last = 0;
    constexpr int kFrames = 20000;
    for (int frame = 0; frame < kFrames; ++frame) {
      source.produce(grid, grid.place(1200, 0), 10, slot.data());
      const double now = power(slot);
      mean += now / kFrames, square += now * now / kFrames, product += now * last / kFrames;
      last = now;
    }
    return std::array<double, 2>{mean, (product - mean * mean) / (square - mean * mean)};
  };
  CHECK(measured(0.5, 0)[0] == doctest::Approx(1).epsilon(0.05));
  CHECK(measured(1, 0)[0] == doctest::Approx(1).epsilon(0.08));
  // Hops overlap, so that half of what one frame is loud is heard in the next anyway.
  CHECK(measured(0.5, 0)[1] < 0.6);
  CHECK(measured(0.5, 0.9)[1] > 0.8);
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

TEST_CASE("a model that cannot be played is refused by name") {
  const auto refused = [](auto change, const char* word) {
    DieselModel model = default_diesel();
    change(model);
    CHECK_THROWS_WITH_AS(DieselLayer({model}, kRate, 1, 800), doctest::Contains(word), std::invalid_argument);
  };
  refused([](auto& m) { m.points.clear(); }, "point");
  refused([](auto& m) { m.angle_samples = 5000; }, "N_theta");
  refused([](auto& m) { m.points[1].slot_variance.pop_back(); }, "v_hi");
  refused([](auto& m) { m.body_filter = {1.0F, -2.1F}; }, "stable");
  refused([](auto& m) { m.points[1].slot_log_variance[3] = 2.5F; }, "points[1].s2: is 2.5, expected 0...2");
  refused([](auto& m) { m.points[0].slot_correlation = 0.96; }, "points[0].rho: is 0.96, expected 0...0.95");
  refused([](auto& m) { m.points[0].rpm = 299; }, "points[0].rpm: is 299 r/min, expected 300...4000 r/min");
  refused([](auto& m) { m.hydraulic.flow = std::nan(""); }, "hydraulic.flow: is nan");
  refused([](auto& m) { m.slots = 48; }, "L: is 48, expected a power of two");
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
