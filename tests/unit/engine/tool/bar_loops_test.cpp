// One steel: its rendered sound against the bar's modes and the modal bank, its bits across lane widths, its
// energy, its sleep.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/heard.hpp"
#include "engine/tool/modal_measure.hpp"
#include "engine/tool/tool_energy.hpp"
#include "engine/tool/tool_sounds.hpp"
#include "rigsound/tool_model.hpp"
#include "tool/bar_loops.hpp"
#include "tool/design/mode_law.hpp"

using namespace rigsound;
using namespace rigsound::tool;
using namespace rigsound::tests;

namespace {

const std::vector<Bar> kBars = {{0.30, 0.030}, {0.30, 0.050}, {0.50, 0.025}, {0.70, 0.030}};

/// The loop as the design says it, no skew, no vectors; `cascade`: its sections, for a sample.
template <class Cascade>
std::vector<double> looped(const LoopDesign& loop, double sign, double k, int samples, Cascade&& cascade) {
  const LoopFilters& f = loop.filters;
  const double R = (1 - f.dc) / (1 + f.dc), gain = sign * dc_gain(R);
  const double s0 = gain * ((f.shelf + f.shelf_gain) / (f.shelf + 1)),
               s1 = gain * ((f.shelf - f.shelf_gain) / (f.shelf + 1)), q = (1 - f.shelf) / (1 + f.shelf);
  double dc = 0, shelf = 0;
  std::vector<double> y;
  for (int n = 0; n < samples; ++n) {
    const double v =
        cascade(n >= loop.delay_samples ? y[static_cast<std::size_t>(n - loop.delay_samples)] : 0);
    const double b = v + dc;
    dc = R * b - v;
    const double w = s0 * b + shelf;
    shelf = s1 * b + q * w;
    y.push_back((n == 0 ? 1.0 : 0.0) + k * w);
  }
  return y;
}

/// One section after the other.
std::vector<double> sequential_response(const LoopDesign& loop, double k, int samples) {
  SectionLanes lanes{};
  int stages = 0;
  for (; stages < loop.allpass.sections; ++stages)
    set_section(lanes, stages, loop.allpass.section[static_cast<std::size_t>(stages)].b,
                loop.allpass.section[static_cast<std::size_t>(stages)].c);
  if (loop.allpass.first_orders) set_section(lanes, stages++, loop.allpass.a, 0);
  return looped(loop, loop.allpass.first_orders ? -1 : 1, k, samples, [&](double v) {
    for (int i = 0; i < stages; ++i) {
      const double half = lanes.g0[i] * lanes.x1[i] - lanes.g1[i] * lanes.x2[i], m = half + lanes.g2[i] * v;
      v = lanes.c0[i] * v - lanes.h[i] * half;
      lanes.x1[i] = m - lanes.x1[i];
      lanes.x2[i] = lanes.x2[i] + m;
    }
    return v;
  });
}

/// The same of the paper's sections (eq. 5).
std::vector<double> sequential_paper_response(const LoopDesign& loop, double k, int samples) {
  const double lambda = (loop.allpass.a - 1) / (loop.allpass.a + 1);
  std::vector<double> before(static_cast<std::size_t>(loop.allpass.first_orders) +
                             1);  // of each, and what enters
  return looped(loop, 1, k, samples, [&](double v) {
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      const double y = lambda * (v - before[i + 1]) + before[i];
      before[i] = v;
      v = y;
    }
    before.back() = v;
    return v;
  });
}

}  // namespace

TEST_CASE("modes measured in the rendered sound are the bar's, with the decay the design tells") {
  for (const double rate : {44100.0, 48000.0, 96000.0})
    for (const Bar& bar : kBars) {
      const ToolModel model = model_of(bar);
      const ToolDesign design = design_tool(model, rate);
      const LoopDesign& loop = design.transversal;
      const double k_ref = 0.5 * (loop.reflection_min + loop.reflection_max);
      const int samples = static_cast<int>(0.05 * rate), every = static_cast<int>(rate / 40000);
      const int order = loop.delay_samples + loop.allpass.order() + 2;
      const auto tuned = measure_modes(impulse_response(design, kTransversal, k_ref, samples), order, every);
      const auto free =
          measure_modes(impulse_response(design, kTransversal, loop.reflection_max, samples), order, every);
      const TransversalLaw law(bar);
      for (const TunedMode& mode : tuned_modes(model, design)) {
        if (mode.family != "transversal") continue;
        CAPTURE(rate);
        CAPTURE(bar.length_m);
        CAPTURE(mode.mode);
        const double wanted = 2 * M_PI * law.at(mode.mode) / rate;
        CHECK(std::fabs(cents(nearest(tuned, wanted).omega, wanted)) <= 1.0);
        CHECK(3 * std::log(10) / -nearest(free, wanted).sigma / rate ==
              doctest::Approx(mode.t60_s).scale(0).epsilon(0.01));
      }
    }
}

TEST_CASE("the loops ring like the sum of their decaying modes") {
  for (const Bar& bar : kBars) {
    const ToolDesign design = design_tool(model_of(bar), 48000);
    const auto rendered = impulse_response(design, kTransversal, 0.89, 2048);
    const auto bank = modal_bank(design.transversal, 0.89, 2048);
    const auto rendered_L = impulse_response(design, kLongitudinal, 0.94, 2048);
    const auto bank_L = modal_bank(design.longitudinal, 0.94, 2048);
    double worst = 0;
    for (std::size_t n = 0; n < rendered.size(); ++n)
      worst = std::max({worst, std::fabs(rendered[n] - bank[n]), std::fabs(rendered_L[n] - bank_L[n])});
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("skewed lanes give the bits of the sections one after another, at either width") {
  for (const double rate : {44100.0, 96000.0})
    for (const Bar& bar : {Bar{0.3, 0.05}, Bar{0.5, 0.025}, Bar{0.47, 0.018}, Bar{1.0, 0.015}}) {
      const ToolDesign design = design_tool(model_of(bar), rate);
      for (const Family family : {kTransversal, kLongitudinal}) {
        const LoopDesign& loop = family == kTransversal ? design.transversal : design.longitudinal;
        const auto reference = sequential_response(loop, 0.87, 4096);
        CHECK(impulse_response(design, family, 0.87, 4096, dsp::LaneWidth::kTwo) == reference);
        if (dsp::widest_lanes() == dsp::LaneWidth::kFour)
          CHECK(impulse_response(design, family, 0.87, 4096, dsp::LaneWidth::kFour) == reference);
      }
    }
}

TEST_CASE("so do loops whose delay line is as short as it may be, or hardly longer") {
  for (const Bar& bar : {Bar{0.3, 0.05}, Bar{0.47, 0.018}})
    for (const int more : {0, 1, 2, 3, 4}) {
      ToolDesign design = design_tool(model_of(bar), 44100);
      for (const Family family : {kTransversal, kLongitudinal}) {
        LoopDesign& loop = family == kTransversal ? design.transversal : design.longitudinal;
        loop.delay_samples = std::max(1, loop.allpass.stages()) + more;
        CAPTURE(bar.length_m);
        CAPTURE(more);
        const auto reference = sequential_response(loop, 0.87, 1024);
        for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()})
          CHECK(impulse_response(design, family, 0.87, 1024, width) == reference);
      }
    }
}

TEST_CASE("so do longitudinal loops of more sections than a bar needs") {
  for (const int sections : {1, 2, 3, 4}) {
    ToolDesign design = design_tool(model_of({0.5, 0.025}), 48000);
    Allpass& allpass = design.longitudinal.allpass;
    allpass = design.transversal.allpass;
    allpass.sections = sections, allpass.first_orders = 0;
    design.longitudinal.delay_samples = 20;
    const auto reference = sequential_response(design.longitudinal, 0.87, 1024);
    CAPTURE(sections);
    for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()})
      CHECK(impulse_response(design, kLongitudinal, 0.87, 1024, width) == reference);
  }
}

TEST_CASE("the paper's sections in vectors give the bits of one after another, at either width") {
  for (const int M : {2, 5, 9, 23, 40, 64})
    for (const int delay : {M, M + 1, M + 2, M + 17}) {
      ToolModel model;
      model.kind = ToolKind::kPaper;
      model.paper.M = M, model.paper.N_T = delay;
      const ToolDesign design = design_tool(model, 48000);
      const auto reference = sequential_paper_response(design.transversal, 0.87, 1024);
      CAPTURE(M);
      CAPTURE(delay);
      for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()})
        CHECK(impulse_response(design, kTransversal, 0.87, 1024, width) == reference);
    }
}

TEST_CASE("energy never grows, whatever k, b and c do from sample to sample") {
  for (const Bar& bar : kBars)
    for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()}) {
      const double growth = largest_energy_growth(design_tool(model_of(bar), 48000), width, 12000);
      CAPTURE(bar.length_m);
      CHECK(growth <= 1e-15);
      CHECK(growth > -1);
    }
}

TEST_CASE("a bar that has died away sleeps with exact zeros and wakes like a new one") {
  const ToolDesign design = design_tool(model_of({0.5, 0.025}), 48000);
  BarLoops bar(design, 800, dsp::widest_lanes());
  Curves strike(0.89, 0.94);
  strike.x[5] = 1;
  const Curves rest(0.89, 0.94);
  double first[kChunk], out[kChunk], again[kChunk];
  bar.process(strike.drive(), first);
  int chunks = 0;
  while (!bar.asleep() && chunks < 5000) bar.process(rest.drive(), out), ++chunks;
  CHECK(chunks > 100);
  CHECK(chunks < 1000);
  bar.process(rest.drive(), out);
  for (const double sample : out) CHECK(sample == 0);
  CHECK(energy(bar.state()) == 0);
  bar.process(strike.drive(), again);
  for (int n = 0; n < kChunk; ++n) CHECK(again[n] == first[n]);
}

TEST_CASE("the high-pass is one of the first order, 6 dB down at its frequency") {
  for (const double rate : {44100.0, 96000.0})
    for (const double highpass_hz : {300.0, 800.0}) {
      const ToolDesign design = design_tool(model_of({0.5, 0.025}), rate);
      BarLoops cut(design, highpass_hz, dsp::widest_lanes()), whole(design, 1e-6, dsp::widest_lanes());
      // H(z) = b (1 - 1/z) / (1 - p / z), 1 at half the rate and 1/2 at its frequency.
      const double omega = 2 * M_PI * highpass_hz / rate;
      const auto gain = [&](double p) {
        const double over = 2 * std::fabs(std::sin(omega / 2));
        return (1 + p) / 2 * over / std::sqrt(1 - 2 * p * std::cos(omega) + p * p);
      };
      double low = 0, high = 1;
      for (int i = 0; i < 60; ++i) (gain((low + high) / 2) > 0.5 ? high : low) = (low + high) / 2;
      const double p = low, b = (1 + p) / 2;
      double before = 0, expected = 0;
      for (int chunk = 0; chunk < 100; ++chunk) {
        Curves strike(0.89, 0.94);
        strike.x[5] = chunk == 0 ? 1 : 0;
        double y[kChunk], heard[kChunk];
        whole.process(strike.drive(), y);
        cut.process(strike.drive(), heard);
        for (int n = 0; n < kChunk; ++n) {
          expected = b * (y[n] - before) + p * expected;
          before = y[n];
          REQUIRE(heard[n] == doctest::Approx(expected).scale(1).epsilon(1e-7));
        }
      }
    }
}
