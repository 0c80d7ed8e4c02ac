// What the layer makes of its waves: the bit it lays under them, the high-pass, fades and the snap.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/string/string_sounds.hpp"
#include "string/longitudinal_string.hpp"
#include "string/string_layer.hpp"
#include "tool/strikes.hpp"

using namespace rigsound;
using namespace rigsound::string;
using namespace rigsound::tests;

namespace {

const double kZ = M_PI / 4 * 0.038 * 0.038 * 7850 * 5200;  // of the plain string, kg/s

StringInput steady(double contact, double rock = 2e8) {
  StringInput input;
  input.contact = contact;
  input.rock_stiffness = rock;
  return input;
}

using BlowPerChunk = std::vector<Impact>;  ///< one a chunk; amplitude 0: none

std::vector<double> played(StringLayer& layer, const StringInput& input, const BlowPerChunk& blows) {
  std::vector<double> sound;
  double out[kChunk];
  for (const Impact& blow : blows) {
    layer.process(input, {&blow, blow.amplitude > 0 ? 1 : 0}, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  return sound;
}

/// A blow in the first of so many chunks.
BlowPerChunk one_blow(std::size_t chunks) {
  BlowPerChunk blows(chunks, Impact{0, 0, 0});
  blows[0] = {3.25, 1, 0};
  return blows;
}

/// The waves over a bit that rests on the rock so softly or lies so far away, high-passed as written: first
/// order, half of 0 dB at highpass_hz.
std::vector<double> waves(const StringModel& model, double contact, double loading, double gap,
                          const BlowPerChunk& blows) {
  Strike strike;
  strike.width_s = model.strike_width_s, strike.amplitude_variation = 0, strike.bounces = 0;
  tool::Strikes strikes(strike, kStringRate, 1, 0);
  LongitudinalString line(model, kStringRate, dsp::widest_lanes());
  line.set_contact(contact);
  line.bit().set_return(1 / (0.005 * kStringRate));
  line.bit().set_loading(loading);
  line.bit().set_gap(gap);
  line.bit().silence();
  const double t = std::sqrt(3) * std::tan(M_PI * model.highpass_hz / kStringRate), p = (1 - t) / (1 + t);
  double x[kChunk], none[kChunk] = {}, heard[kChunk], last = 0, y = 0;
  std::vector<double> sound;
  for (const Impact& blow : blows) {
    strikes.process({&blow, blow.amplitude > 0 ? 1 : 0}, StringInput{}.period, x);
    line.process({x, none, heard});
    for (const double wave : heard) {
      const double u = model.level * model.string_mix * wave;
      y = (1 + p) / 2 * (u - last) + p * y;
      last = u;
      sound.push_back(y);
    }
  }
  return sound;
}

double largest(const std::vector<double>& x) {
  double most = 0;
  for (const double v : x) most = std::max(most, std::fabs(v));
  return most;
}

}  // namespace

TEST_CASE("rock loads the bit in Z / k, the feed closes the gap that a mean blow crosses at half of it") {
  StringModel model = plain_string();
  model.bending_mix = 0;
  const double width = model.strike_width_s * kStringRate;
  for (const double contact : {1.0, 0.75, 0.5, 0.25, 0.0})
    for (const double rock : {5e7, 1e9}) {
      StringLayer layer(model, kStringRate, 1, 0);
      played(layer, steady(contact, rock), BlowPerChunk(2000, Impact{0, 0, 0}));
      const std::vector<double> sound = played(layer, steady(contact, rock), one_blow(200));
      const double gap = contact == 0 ? -1 : contact == 0.5 ? width : width * (1 / contact - 1);
      const std::vector<double> wanted = waves(model, contact, kZ / rock * kStringRate, gap, one_blow(200));
      CAPTURE(contact);
      CAPTURE(rock);
      REQUIRE(largest(wanted) > 0.001);
      double worst = 0;
      for (std::size_t n = 0; n < sound.size(); ++n) worst = std::max(worst, std::fabs(sound[n] - wanted[n]));
      CHECK(worst < 1e-9 * largest(wanted));
    }
}

TEST_CASE("contact comes and goes within 20 ms, the rock's stiffness with a time constant of 20 ms") {
  StringModel model = plain_string();
  model.bending_mix = 0;
  StringLayer layer(model, kStringRate, 1, 0);
  played(layer, steady(0, 1e9), BlowPerChunk(2000, Impact{0, 0, 0}));
  played(layer, steady(1, 1e9), BlowPerChunk(30, Impact{0, 0, 0}));  // 20 ms
  StringLayer there = layer;
  const BlowPerChunk ringing = one_blow(100);
  std::vector<double> sound = played(there, steady(1, 1e9), ringing);
  CHECK(largest(sound) > 0);
  const std::vector<double> pressed = waves(model, 1, kZ / 1e9 * kStringRate, 0, ringing);
  for (std::size_t n = 0; n < sound.size(); ++n) REQUIRE(sound[n] == doctest::Approx(pressed[n]).scale(0.01));

  // A millisecond later softer rock is felt by 1 - e^-1/20 of the way.
  StringLayer early = layer, late = layer;
  played(early, steady(1, 1e8), BlowPerChunk(30, Impact{0, 0, 0}));
  played(late, steady(1, 1e8), BlowPerChunk(60, Impact{0, 0, 0}));
  const auto of = [&](const StringLayer& after, double left) {
    StringLayer copy = after;
    const double hard = kZ / 1e9 * kStringRate, soft = kZ / 1e8 * kStringRate;
    const std::vector<double> got = played(copy, steady(1, 1e8), one_blow(60));
    const std::vector<double> wanted = waves(model, 1, soft + (hard - soft) * left, 0, one_blow(60));
    double error = 0;
    for (std::size_t n = 0; n < got.size(); ++n) error = std::max(error, std::fabs(got[n] - wanted[n]));
    return error / largest(wanted);
  };
  CHECK(of(early, std::exp(-1)) < of(early, 0));
  CHECK(of(early, std::exp(-1)) < of(early, 1));
  CHECK(of(late, std::exp(-2)) < of(late, std::exp(-1)));
}

TEST_CASE(
    "a change of rods takes the old string away, and brings the new one, along 3 g^2 - 2 g^3 in 20 ms") {
  const StringModel model = plain_string();
  const int fade = 960;
  const auto g = [&](std::size_t n) {
    const double x = static_cast<double>(n) / fade;
    return x * x * (3 - 2 * x);
  };
  StringLayer stays(model, kStringRate, 1, 0), changes(model, kStringRate, 1, 0);
  StringInput six = steady(0.5);
  six.rods = 6;
  played(stays, steady(0.5), BlowPerChunk(100, Impact{0, 0, 0}));
  played(changes, steady(0.5), BlowPerChunk(100, Impact{0, 0, 0}));
  CHECK(played(stays, steady(0.5), one_blow(4)) == played(changes, steady(0.5), one_blow(4)));
  const BlowPerChunk none(fade / kChunk, Impact{0, 0, 0});
  const std::vector<double> whole = played(stays, steady(0.5), none), out = played(changes, six, none);
  REQUIRE(largest(whole) > 1e-4);
  for (std::size_t n = 0; n < out.size(); ++n)
    CHECK(out[n] == doctest::Approx(whole[n] * g(fade - n)).scale(largest(whole)).epsilon(1e-9));

  StringLayer born(plain_string(3.66, 0.038, 6), kStringRate, 1, 0);
  played(born, six, BlowPerChunk(130, Impact{0, 0, 0}));
  BlowPerChunk blows(fade / kChunk, Impact{0, 0, 0});
  blows[0] = {3.25, 1, 1};
  const std::vector<double> full = played(born, six, blows), in = played(changes, six, blows);
  REQUIRE(largest(full) > 1e-4);
  for (std::size_t n = 0; n < in.size(); ++n)
    CHECK(in[n] == doctest::Approx(full[n] * g(n)).scale(largest(full)).epsilon(1e-9));
  CHECK(played(changes, six, none) == played(born, six, none));
}

TEST_CASE("the rod may move by 0.3 m at once without a fade, and no more") {
  const StringModel model = plain_string();
  for (const double moved_m : {-0.29, -0.31}) {
    StringLayer layer(model, kStringRate, 1, 0), still(model, kStringRate, 1, 0);
    StringInput moved = steady(0.5);
    moved.exposed_m += moved_m;
    played(layer, steady(0.5), one_blow(100)), played(still, steady(0.5), one_blow(100));
    const std::vector<double> a = played(layer, moved, one_blow(30)),
                              b = played(still, steady(0.5), one_blow(30));
    double energy_a = 0, energy_b = 0;  // of the last three milliseconds of a fade
    for (std::size_t n = 800; n < 960; ++n) energy_a += a[n] * a[n], energy_b += b[n] * b[n];
    CAPTURE(moved_m);
    CHECK((energy_a < 0.05 * energy_b) == (moved_m < -0.3));
  }
}

TEST_CASE("a snap is as loud as its model says, whatever rang before") {
  const auto snap = [](double snap_db) {
    StringModel model = plain_string();
    model.snap_db = snap_db;
    StringLayer layer(model, kStringRate, 1, 0);
    StringInput input = steady(0);
    played(layer, input, BlowPerChunk(100, Impact{0, 0, 0}));
    input.broken = true;
    return played(layer, input, BlowPerChunk(200, Impact{0, 0, 0}));
  };
  const std::vector<double> quiet = snap(0), loud = snap(20);
  REQUIRE(largest(quiet) > 0);
  for (std::size_t n = 0; n < quiet.size(); ++n)
    CHECK(loud[n] == doctest::Approx(10 * quiet[n]).scale(largest(quiet)).epsilon(1e-9));
}
