#include "simulate/rattling_recipe.hpp"

namespace rigsound::analysis {
namespace {

ClickProcess process(double jitter, double amplitude_cv, double amplitude_rho) {
  ClickProcess p;
  p.jitter = jitter, p.amplitude_cv = amplitude_cv, p.amplitude_rho = amplitude_rho;
  return p;
}

/// Loose joints: 18-25 Hz, the rods ring and the piston bounces.
RattlingRecipe closed_rattling() {
  ClickProcess p = process(.08, .25, .2);
  p.bounce = Bounce{0.05, 0.10, 0.3, 0.6};
  return {19,
          24,
          p,
          16,
          0,
          14,
          {highpass(150), one_pole(8000), peaking(1250, 10, 6), peaking(2900, 9, 6), peaking(5200, 8, 5)},
          -1,
          1600};
}

/// No rock at all: a short, very loud and bright burst.
RattlingRecipe open_rattling() {
  return {40,
          45,
          process(.06, .2, .3),
          10,
          3,
          16,
          {highpass(700), one_pole(12000), peaking(3400, 10, 4), peaking(6100, 12, 5), peaking(9300, 8, 4)},
          12,
          1500};
}

}  // namespace

RattlingRecipe rattling_recipe(Situation situation) {
  return situation == Situation::kOpenRattling ? open_rattling() : closed_rattling();
}

}  // namespace rigsound::analysis
