// The tool layer as a whole: its sameness across rates, its live changes, its sleep.
#include "tool/tool_layer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/allocation_guard.hpp"
#include "engine/heard.hpp"
#include "engine/tool/sound_levels.hpp"
#include "engine/tool/tool_sounds.hpp"

using namespace rigsound;
using namespace rigsound::tool;
using namespace rigsound::tests;

namespace {

std::function<ToolInput(double)> from(double change_s, const std::function<void(ToolInput&)>& change) {
  return [=](double t) {
    ToolInput controls;
    if (t >= change_s) change(controls);
    return controls;
  };
}

}  // namespace

TEST_CASE("one blow sounds the same at 44.1, 48 and 96 kHz") {
  for (const Bar bar : {Bar{0.3, 0.03}, Bar{0.5, 0.025}, Bar{0.7, 0.03}}) {
    std::vector<std::vector<double>> levels;
    for (const double rate : {44100.0, 48000.0, 96000.0})
      levels.push_back(third_octaves_db(one_blow(plain_model(bar), rate), rate));
    CHECK(largest_difference_db(levels) <= 0.6);
  }
}

TEST_CASE("live changes leave nothing above 12 kHz") {
  const double change_s = 0.5;
  const auto residue = [&](const std::function<void(ToolInput&)>& change) {
    ToolLayer layer(long_ringing_model(), kRate, 1, 0);
    return residue_db(struck(layer, {kRate, 0.7, 0.1}, from(change_s, change)), kRate, change_s - 0.01,
                      change_s + 0.05);
  };
  CHECK(residue([](ToolInput&) {}) <= -110);
  CHECK(residue([](ToolInput& c) { c.rods = 2; }) <= -100);
  CHECK(residue([](ToolInput& c) { c.transversal_reflection = 0.93, c.longitudinal_reflection = 0.95; }) <=
        -90);
  CHECK(residue([](ToolInput& c) { c.transversal_mix = 0.3, c.longitudinal_mix = 2; }) <= -90);
}

TEST_CASE("live controls end where they were asked to") {
  const ToolModel model = plain_model();
  const auto with = [&](double change_s, const std::function<void(ToolInput&)>& change) {
    ToolLayer layer(model, kRate, 1, 0);
    return after(struck(layer, {kRate, 0.5, 0.2}, from(change_s, change)), 0.2);
  };
  const auto plain = with(0, [](ToolInput&) {});
  const auto softer = with(0.1, [](ToolInput& c) { c.amplitude = 0.25; });
  const auto bending = with(0.1, [](ToolInput& c) { c.longitudinal_mix = 0; });
  const auto stretching = with(0.1, [](ToolInput& c) { c.transversal_mix = 0; });
  const auto damped =
      with(0.1, [](ToolInput& c) { c.transversal_reflection = 0.9, c.longitudinal_reflection = 0.9; });
  double energy = 0, damped_energy = 0;
  for (std::size_t n = 0; n < plain.size(); ++n) {
    CHECK(softer[n] == doctest::Approx(0.25 * plain[n]).epsilon(1e-9));
    CHECK(bending[n] + stretching[n] == doctest::Approx(plain[n]).epsilon(1e-9));
    if (n > 1000) energy += plain[n] * plain[n], damped_energy += damped[n] * damped[n];
  }
  CHECK(damped_energy < 0.1 * energy);
  CHECK(damped_energy > 0);
}

TEST_CASE("20 ms after a change of steel the new one rings alone, as if there had never been another") {
  ToolModel model = plain_model();
  model.rods = {{2, {0.55, 0.025}}, {3, {0.40, 0.020}}};
  const auto last_blow = [&](const std::function<ToolInput(double)>& controls, const Bar& bar) {
    ToolLayer changing(model, kRate, 1, 0), born(plain_model(bar), kRate, 1, 0);
    // The first blow still rings when the steel changes; the second comes a quarter of a second later.
    const auto sound = struck(changing, {kRate, 0.5, 0.05, 0.25}, controls);
    const auto alone = struck(born, {kRate, 0.5, 0.30, 0.25}, [](double) { return ToolInput{}; });
    return std::pair{after(sound, 0.29), after(alone, 0.29)};
  };
  const auto [second, as_second] = last_blow(from(0.06, [](ToolInput& c) { c.rods = 2; }), {0.55, 0.025});
  CHECK(second == as_second);
  // Two changes at once: the later waits for the crossfade of the earlier to end, and wins.
  const auto twice = [](double t) {
    ToolInput c;
    c.rods = t < 0.06 ? 1 : t < 0.07 ? 2 : 3;
    return c;
  };
  const auto [third, as_third] = last_blow(twice, {0.40, 0.020});
  CHECK(third == as_third);
}

TEST_CASE("a layer left alone falls silent with exact zeros, its equaliser too") {
  ToolModel model = plain_model();
  model.voicing.equaliser = {{200, 12, 8}, {2000, -4, 1.4}};
  ToolLayer layer(model, kRate, 1, 0);
  const auto sound = struck(layer, {kRate, 3.0, 0.01}, from(1e9, [](ToolInput&) {}));
  for (const double x : after(sound, 2.0)) CHECK(x == 0);
}

TEST_CASE("the layer repeats itself bit for bit, differs between booms, and never allocates") {
  ToolModel model;
  model.rods = {{3, {0.7, 0.03}}};
  model.voicing.equaliser = {{2000, -4, 1.4}};
  const auto controls = from(0.2, [](ToolInput& c) { c.rods = 3; });
  ToolLayer first(model, kRate, 9, 0), again(model, kRate, 9, 0), other(model, kRate, 9, 1);
  ToolLayer narrow(model, kRate, 9, 0, dsp::LaneWidth::kTwo);
  const Blows blows{kRate, 0.5, 0.01, 0.03};
  const auto sound = struck(first, blows, controls);
  CHECK(struck(again, blows, controls) == sound);
  CHECK(struck(narrow, blows, controls) == sound);
  CHECK(struck(other, blows, controls) != sound);
  double out[kChunk];
  const long before = allocations();
  for (int chunk = 0; chunk < 500; ++chunk) {
    const Impact blow{1.5, 1, static_cast<std::uint64_t>(chunk)};
    ToolInput c;
    c.rods = chunk > 250 ? 1 : 3;
    first.process(c, {&blow, chunk % 40 == 0}, out);
  }
  CHECK(allocations() == before);
}

TEST_CASE("the weight of either family goes from 0 to 1 in 10 ms, in a straight line, and so do the blows") {
  ToolModel model;
  model.strike.bounces = 0;
  const double step = 1 / (0.010 * 48000);
  constexpr int kChange = 20;
  // From the change on: until then `gain` is `before`, then `after`.
  const auto played = [&](double ToolInput::*gain, double before, double after, int blow_chunk) {
    ToolLayer layer(model, 48000, 1, 0);
    std::vector<double> sound;
    for (int chunk = 0; chunk < 60; ++chunk) {
      ToolInput input;
      input.*gain = chunk < kChange ? before : after;
      const Impact blow{3.25, 1, 0};
      double out[kChunk];
      layer.process(input, {&blow, chunk == blow_chunk ? 1 : 0}, out);
      if (chunk >= kChange) sound.insert(sound.end(), out, out + kChunk);
    }
    return sound;
  };
  for (const auto gain : {&ToolInput::transversal_mix, &ToolInput::longitudinal_mix}) {
    const auto full = played(gain, 1, 1, kChange - 1), none = played(gain, 0, 0, kChange - 1),
               changed = played(gain, 0, 1, kChange - 1);
    double loudest = 0, worst = 0;
    for (std::size_t n = 0; n < full.size(); ++n) {
      const double part = full[n] - none[n], share = std::min(1.0, static_cast<double>(n + 1) * step);
      loudest = std::max(loudest, std::fabs(part));
      worst = std::max(worst, std::fabs(changed[n] - none[n] - share * part));
    }
    CHECK(loudest > 0);
    CHECK(worst < 1.01 * step * loudest);  // where in a sample it begins is left open
  }
  // A pulse of 11 samples in the midst of the ramp.
  for (const int later : {2, 5, 8}) {
    const auto full = played(&ToolInput::amplitude, 1, 1, kChange + later),
               changed = played(&ToolInput::amplitude, 0, 1, kChange + later);
    double most = 0, less = 0;
    for (std::size_t n = 0; n < full.size(); ++n)
      most = std::max(most, std::fabs(full[n])), less = std::max(less, std::fabs(changed[n]));
    CAPTURE(later);
    CHECK(less / most == doctest::Approx((later * kChunk + 3.25 + 5.5) * step).epsilon(0.05));
  }
}
