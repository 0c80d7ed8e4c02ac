#include <cmath>
#include <tuple>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/tool_model.hpp"
#include "tool/design/decay_solver.hpp"
#include "tool/design/loop_designer.hpp"
#include "tool/design/loop_response.hpp"

namespace rigsound {
namespace {

using namespace tool;

constexpr double kDcBlocker_hz = 20;  // -6.02 dB there, at every rate

LoopFilters filters_of(const Decay& decay, double sample_rate) {
  return {std::sqrt(3.0) * dsp::tan(dsp::kPi * kDcBlocker_hz / sample_rate),
          dsp::tan(dsp::kPi * decay.shelf_hz / sample_rate), decay.shelf_gain};
}

LoopTask transversal_task(const ToolModel& model, double sample_rate) {
  LoopTask task;
  task.sample_rate = sample_rate;
  task.filters = filters_of(model.transversal, sample_rate);
  task.k_min = model.transversal.reflection_min, task.k_max = model.transversal.reflection_max;
  return task;
}

/// The longitudinal loop is short and nearly harmonic: few sections, and a coarser hold on the decays.
LoopTask longitudinal_task(const ToolModel& model, double sample_rate) {
  LoopTask task;
  task.sample_rate = sample_rate;
  task.filters = filters_of(model.longitudinal, sample_rate);
  task.k_min = task.k_max = model.longitudinal.reflection_max;
  task.decay_share = 0.10;
  task.beside_weight = 0.02;
  task.lowest_order = 1;
  task.preferred_order = 5;
  task.max_order = 2 * kMaxLongSections;
  task.spare_delay = 1e3;
  return task;
}

/// Gain and round trip depend on each other through the allpass, so the two are settled in turns.
LoopDesign design_family(const ModeLaw& law, LoopTask task, const DecayWish& wish) {
  const double k_ratio = task.k_min / task.k_max;
  DesignedLoop found = design_loop(law, task);
  if (wish.low_s == 0) return found.loop;
  for (int i = 0; i < 8; ++i) {
    const DecayGains gains = solve_decay(found.loop, wish, task.sample_rate);
    if (std::fabs(gains.k - task.k_max) < 1e-9 && std::fabs(gains.g - task.filters.shelf_gain) < 1e-9) break;
    task.filters.shelf_gain = gains.g;
    task.k_max = gains.k, task.k_min = gains.k * k_ratio;
    found = retune_loop(law, task, found.loop);
    if (found.error.cents > task.cents_limit || found.error.decay_share > task.decay_share)
      found = design_loop(law, task);
  }
  return found.loop;
}

LoopDesign paper_loop(const Decay& decay, double sample_rate, int N, int M, double lambda) {
  LoopDesign loop;
  loop.delay_samples = N;
  loop.allpass.first_orders = M;
  loop.allpass.a = (1 + lambda) / (1 - lambda);
  loop.filters = filters_of(decay, sample_rate);
  loop.reflection_min = decay.reflection_min, loop.reflection_max = decay.reflection_max;
  return loop;
}

double total_lag(const LoopDesign& loop, double omega) {
  return lag(loop.allpass, omega) + loop.delay_samples * omega + lag(loop.filters, omega);
}

/// Frequency at which the wave comes back `mode` turns later, rad/sample; pi when there is none.
double omega_of_mode(const LoopDesign& loop, int mode) {
  double low = 1e-6, high = dsp::kPi * (1 - 1e-9);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (total_lag(loop, middle) < dsp::kTwoPi * mode ? low : high) = middle;
  }
  return high;
}

void append_modes(std::vector<TunedMode>& modes, std::string_view family, const ModeLaw& law,
                  const LoopDesign& loop, double sample_rate) {
  const double to_hz = sample_rate / dsp::kTwoPi, k_ref = 0.5 * (loop.reflection_min + loop.reflection_max);
  const int count = law.count_below(mode_limit(sample_rate));
  for (int k = 1; k <= count; ++k) {
    const double omega = omega_of_mode(loop, k);
    const double model = closed_loop_pole(loop, k_ref, omega).omega * to_hz, target = law.at(k);
    const double t60 = t60_samples(closed_loop_pole(loop, loop.reflection_max, omega).sigma) / sample_rate;
    modes.push_back({family, k, target, model, 1200 / dsp::kLn2 * dsp::log(model / target), t60});
  }
}

DesignInput input_of(const ToolModel& model) { return {model.bar, model.transversal, model.longitudinal}; }

auto values(const DecayWish& w) { return std::tie(w.low_hz, w.low_s, w.high_hz, w.high_s); }

auto values(const Decay& d) {
  return std::tuple_cat(std::tie(d.reflection_min, d.reflection_max, d.shelf_gain, d.shelf_hz),
                        values(d.wish));
}

}  // namespace

bool operator==(const DesignInput& a, const DesignInput& b) noexcept {
  return a.bar.length_m == b.bar.length_m && a.bar.diameter_m == b.bar.diameter_m &&
         values(a.transversal) == values(b.transversal) && values(a.longitudinal) == values(b.longitudinal);
}

ToolDesign design_tool(const ToolModel& model, double sample_rate) {
  require_valid(model, sample_rate);
  ToolDesign design;
  design.sample_rate = sample_rate;
  design.made_for = input_of(model);
  if (model.kind == ToolKind::kPaper) {
    const PaperLoops& paper = model.paper;
    design.transversal = paper_loop(model.transversal, sample_rate, paper.N_T, paper.M, paper.lambda);
    design.longitudinal = paper_loop(model.longitudinal, sample_rate, paper.N_L, 0, 0);
    return design;
  }
  design.transversal =
      design_family(TransversalLaw(model.bar), transversal_task(model, sample_rate), model.transversal.wish);
  design.longitudinal = design_family(LongitudinalLaw(model.bar), longitudinal_task(model, sample_rate),
                                      model.longitudinal.wish);
  return design;
}

ToolDesign design_for(const ToolModel& model, double sample_rate) {
  require_valid(model, sample_rate);
  for (const ToolDesign& design : model.designs)
    if (design.sample_rate == sample_rate && design.made_for == input_of(model)) return design;
  return design_tool(model, sample_rate);
}

std::vector<TunedMode> tuned_modes(const ToolModel& model, const ToolDesign& design) {
  std::vector<TunedMode> modes;
  append_modes(modes, "transversal", TransversalLaw(model.bar), design.transversal, design.sample_rate);
  append_modes(modes, "longitudinal", LongitudinalLaw(model.bar), design.longitudinal, design.sample_rate);
  return modes;
}

}  // namespace rigsound
