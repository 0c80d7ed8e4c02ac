// Bars of 0.3...1 m and 15...50 mm, drawn at random: poles of the closed loops against the laws of the bar.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/tool/row.hpp"
#include "bench/tool/rows.hpp"
#include "engine/heard.hpp"
#include "engine/tool/design/elastic_modes.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/tool_model.hpp"
#include "tool/design/loop_designer.hpp"
#include "tool/design/loop_response.hpp"
#include "tool/design/mode_law.hpp"

namespace rigsound::bench {
namespace {

using namespace tool;
using tests::cents;

constexpr int kBars = 500;

template <class Law>
double cents_from_elasticity(const std::vector<tests::ReferenceBar>& references) {
  double worst = 0;
  for (const tests::ReferenceBar& reference : references)
    for (std::size_t i = 0; i < reference.elastic.size(); ++i)
      worst = std::max(
          worst, std::fabs(cents(Law(reference.bar).at(static_cast<double>(i) + 1), reference.elastic[i])));
  return worst;
}

Bar random_bar(std::uint64_t i) {
  const dsp::RandomField random(500, 1);
  return {0.3 + 0.7 * random.uniform(i, 0), 0.015 + 0.035 * random.uniform(i, 1)};
}

/// How far the worst mode of `loop` is off, with reflection `k`.
LoopError error_of(const LoopDesign& loop, const ModeLaw& law, double k, double rate) {
  LoopError error;
  const int modes = law.count_below(mode_limit(rate));
  for (int mode = 1; mode <= modes; ++mode) {
    const double wanted = dsp::kTwoPi * law.at(mode) / rate;
    const Pole pole = closed_loop_pole(loop, k, wanted);
    const double t60 = ideal_t60_samples(law, loop.filters, k, mode, rate);
    error.cents = std::max(error.cents, std::fabs(cents(pole.omega, wanted)));
    error.decay_share = std::max(error.decay_share, std::fabs(t60_samples(pole.sigma) / t60 - 1));
  }
  return error;
}

/// Worst of all bars of one family at one rate.
struct Family {
  double cents = 0, cents_across = 0, decay_share = 0;
  int order = 0, least_spare_delay = 1000;

  void add(const LoopDesign& loop, const ModeLaw& law, double k_tuned, const std::vector<double>& across,
           double rate) {
    const LoopError tuned = error_of(loop, law, k_tuned, rate);
    cents = std::max(cents, tuned.cents);
    decay_share = std::max(decay_share, tuned.decay_share);
    for (const double k : across) cents_across = std::max(cents_across, error_of(loop, law, k, rate).cents);
    order = std::max(order, loop.allpass.order());
    least_spare_delay = std::min(least_spare_delay, loop.delay_samples - (loop.allpass.order() + 1) / 2);
  }
};

struct Bars {
  Family T, L;
  int failures = 0;
  std::vector<double> seconds;
};

Bars designed(double rate) {
  Bars all;
  for (std::uint64_t i = 0; i < kBars; ++i) {
    ToolModel model;
    model.bar = random_bar(i);
    const std::clock_t start = std::clock();
    try {
      const ToolDesign design = design_tool(model, rate);
      all.seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      all.T.add(design.transversal, TransversalLaw(model.bar), 0.86, {0.83, 0.845, 0.875, 0.89}, rate);
      all.L.add(design.longitudinal, LongitudinalLaw(model.bar), 0.94, {0.90, 0.92}, rate);
    } catch (const std::invalid_argument&) {
      ++all.failures;
    }
  }
  std::sort(all.seconds.begin(), all.seconds.end());
  return all;
}

void print_bars(double rate) {
  const Bars bars = designed(rate);
  const auto row = [&](const std::string& what, double wanted, double reached, const std::string& unit) {
    print({std::to_string(kBars) + " bars at " + std::to_string(static_cast<int>(rate)) + " Hz: " + what,
           Bound::kAtMost, wanted, reached, unit});
  };
  row("designer failures", 0, bars.failures, "");
  row("T poles, k_T = 0.86", 1.0, bars.T.cents, "cents");
  row("T poles, k_T = 0.86, aimed for", 0.3, bars.T.cents, "cents");
  row("T poles, k_T 0.83...0.89", 1.2, bars.T.cents_across, "cents");
  row("L poles, k_L = 0.94", 1.0, bars.L.cents, "cents");
  row("L poles, k_L 0.90...0.94", 1.3, bars.L.cents_across, "cents");
  row("T order", 30, bars.T.order, "");
  row("L order", 5, bars.L.order, "");
  row("T ceil(p/2) - N", 0, -bars.T.least_spare_delay, "");
  row("L ceil(p/2) - N", 0, -bars.L.least_spare_delay, "");
  row("T T60 of every mode", 3, 100 * bars.T.decay_share, "%");
  row("L T60 of every mode", 10, 100 * bars.L.decay_share, "%");
  std::printf("%d bars at %g Hz: design of both loops, 95 of 100 within %.3g ms\n", kBars, rate,
              1e3 * bars.seconds[bars.seconds.size() * 95 / 100]);
}

/// A wish that some passive loop can grant: the decays of the law's own loop with these gains.
DecayWish random_wish(const ModeLaw& law, std::uint64_t i, double rate) {
  const dsp::RandomField random(60, 2);
  const double k = 0.85 + 0.12 * random.uniform(i, 0), g = 0.6 + 0.3 * random.uniform(i, 1);
  const LoopFilters filters{std::sqrt(3.0) * dsp::tan(dsp::kPi * 20 / rate), dsp::tan(dsp::kPi * 6000 / rate),
                            g};
  const int modes = law.count_below(mode_limit(rate)), high = std::max(2, modes * 2 / 3);
  const auto seconds = [&](int mode) { return ideal_t60_samples(law, filters, k, mode, rate) / rate; };
  return {law.at(1), seconds(1), law.at(high), seconds(high)};
}

double wish_error(const LoopDesign& loop, const DecayWish& wish, double rate) {
  const auto error = [&](double hz, double seconds) {
    const Pole pole = closed_loop_pole(loop, loop.reflection_max, dsp::kTwoPi * hz / rate);
    return std::fabs(t60_samples(pole.sigma) / rate / seconds - 1);
  };
  return std::max(error(wish.low_hz, wish.low_s), error(wish.high_hz, wish.high_s));
}

void print_wishes() {
  double T = 0, L = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const double rate = std::vector<double>{44100, 48000, 96000}[i % 3];
    ToolModel model;
    model.bar = random_bar(i);
    model.transversal.wish = random_wish(TransversalLaw(model.bar), i, rate);
    model.longitudinal.wish = random_wish(LongitudinalLaw(model.bar), i, rate);
    const ToolDesign design = design_tool(model, rate);
    T = std::max(T, wish_error(design.transversal, model.transversal.wish, rate));
    L = std::max(L, wish_error(design.longitudinal, model.longitudinal.wish, rate));
  }
  print({"60 bars with wanted decays: T T60 at the two targets", Bound::kAtMost, 0.1, 100 * T, "%"});
  print({"60 bars with wanted decays: L T60 at the two targets", Bound::kAtMost, 0.1, 100 * L, "%"});
}

}  // namespace

void print_tuning() {
  print({"T modes 1...10 against three-dimensional elasticity, 4 bars", Bound::kAtMost, 1,
         cents_from_elasticity<TransversalLaw>(tests::kTransversalReference), "cents"});
  print({"L modes against three-dimensional elasticity, 3 bars", Bound::kAtMost, 1,
         cents_from_elasticity<LongitudinalLaw>(tests::kLongitudinalReference), "cents"});
  for (const double rate : {44100.0, 48000.0, 96000.0}) print_bars(rate);
  print_wishes();
}

}  // namespace rigsound::bench
