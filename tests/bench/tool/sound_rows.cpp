// What can be measured in the rendered sound itself.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/tool/row.hpp"
#include "bench/tool/rows.hpp"
#include "engine/tool/modal_measure.hpp"
#include "engine/tool/sound_levels.hpp"
#include "engine/tool/tool_energy.hpp"
#include "engine/tool/tool_sounds.hpp"
#include "tool/design/mode_law.hpp"

namespace rigsound::bench {
namespace {

using namespace tests;
using namespace tool;

const std::vector<Bar> kBars = {{0.30, 0.030}, {0.30, 0.050}, {0.50, 0.025},
                                {0.50, 0.050}, {0.70, 0.030}, {1.00, 0.015}};

struct Measured {
  double cents = 0, decay_share = 0;
};

/// Modes of a loop heard in its sound. The low ones in a longer stretch at a quarter of the rate, where they
/// lie further apart.
class Heard {
 public:
  Heard(const ToolDesign& design, Family family, double k) {
    const LoopDesign& loop = family == kTransversal ? design.transversal : design.longitudinal;
    const int order = loop.delay_samples + loop.allpass.order() + 2,
              every = static_cast<int>(design.sample_rate / 40000);
    const auto sound = impulse_response(design, family, k, static_cast<int>(0.2 * design.sample_rate));
    high_ = measure_modes({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(sound.size() / 4)},
                          order, every);
    low_ = measure_modes(sound, order, 4 * every);
    border_ = 0.7 * M_PI / (4 * every);
  }

  MeasuredMode at(double omega) const { return nearest(omega < border_ ? low_ : high_, omega); }

 private:
  std::vector<MeasuredMode> low_, high_;
  double border_;
};

/// Modes of one family against the law, and against the decay the design tells.
Measured measured(const ToolModel& model, double rate, Family family) {
  const ToolDesign design = design_tool(model, rate);
  const LoopDesign& loop = family == kTransversal ? design.transversal : design.longitudinal;
  const Heard tuned(design, family, 0.5 * (loop.reflection_min + loop.reflection_max)),
      free(design, family, loop.reflection_max);
  Measured worst;
  for (const TunedMode& mode : tuned_modes(model, design)) {
    if ((mode.family == "transversal") != (family == kTransversal)) continue;
    const double wanted = 2 * M_PI * mode.target_hz / rate;
    const double t60 = 3 * std::log(10) / -free.at(wanted).sigma / rate;
    worst.cents = std::max(worst.cents, std::fabs(1200 * std::log2(tuned.at(wanted).omega / wanted)));
    worst.decay_share = std::max(worst.decay_share, std::fabs(t60 / mode.t60_s - 1));
  }
  return worst;
}

void print_rendered_modes() {
  for (const Family family : {kTransversal, kLongitudinal}) {
    Measured worst;
    for (const double rate : {44100.0, 48000.0, 96000.0})
      for (const Bar& bar : kBars) {
        const Measured m = measured(model_of(bar), rate, family);
        worst = {std::max(worst.cents, m.cents), std::max(worst.decay_share, m.decay_share)};
      }
    const std::string who = family == kTransversal ? "T" : "L";
    print({who + " modes in the rendered sound, 6 bars, 3 rates", Bound::kAtMost, 1, worst.cents, "cents"});
    print({who + " T60 in the rendered sound, 6 bars, 3 rates", Bound::kAtMost, 1, 100 * worst.decay_share,
           "%"});
  }
}

void print_rates() {
  double worst = 0;
  for (const Bar& bar : kBars) {
    std::vector<std::vector<double>> levels;
    for (const double rate : {44100.0, 48000.0, 96000.0})
      levels.push_back(third_octaves_db(one_blow(plain_model(bar), rate), rate));
    worst = std::max(worst, largest_difference_db(levels));
  }
  print({"one blow at 44.1, 48, 96 kHz, 6 bars: third-octaves 125 Hz...15 kHz", Bound::kAtMost, 0.6, worst,
         "dB"});
}

void print_energy() {
  double worst = -1;
  for (const Bar& bar : kBars)
    for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()})
      worst = std::max(worst, largest_energy_growth(design_tool(model_of(bar), 48000), width, 60000));
  print({"growth of zero-input energy in a sample, random k in [-1, 1], b, c", Bound::kAtMost, 1e-15, worst,
         ""});
}

double residue(const ToolModel& model, double rate, void (*change)(ToolInput&)) {
  constexpr double kChange_s = 0.5;
  ToolLayer layer(model, rate, 1, 0);
  const auto sound = struck(layer, {rate, 0.7, 0.1}, [&](double t) {
    ToolInput controls;
    if (t >= kChange_s) change(controls);
    return controls;
  });
  return residue_db(sound, rate, kChange_s - 0.01, kChange_s + 0.05);
}

void print_residues() {
  double bar = -300, k = -300, gain = -300;
  for (const double rate : {44100.0, 48000.0, 96000.0}) {
    ToolModel model = long_ringing_model();
    for (const double length : {0.505, 0.55, 0.8}) {
      model.rods = {{2, {length, 0.025}}, {3, {0.5, 0.040}}};
      bar = std::max(bar, residue(model, rate, [](ToolInput& c) { c.rods = 2; }));
    }
    bar = std::max(bar, residue(model, rate, [](ToolInput& c) { c.rods = 3; }));
    k = std::max(k, residue(model, rate, [](ToolInput& c) {
                   c.transversal_reflection = 0.93, c.longitudinal_reflection = 0.93;
                 }));
    gain = std::max(
        gain, residue(model, rate, [](ToolInput& c) { c.transversal_mix = 0.3, c.longitudinal_mix = 2; }));
  }
  print({"another length or diameter while it rings: above 12 kHz", Bound::kAtMost, -100, bar, "dB"});
  print({"k_T and k_L ramp by 7 %: above 12 kHz", Bound::kAtMost, -90, k, "dB"});
  print({"mix ramps by -10 and +6 dB: above 12 kHz", Bound::kAtMost, -90, gain, "dB"});
}

}  // namespace

void print_sound() {
  print_rendered_modes();
  print_rates();
  print_energy();
  print_residues();
}

}  // namespace rigsound::bench
