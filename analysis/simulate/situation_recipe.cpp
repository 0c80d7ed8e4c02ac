#include "simulate/situation_recipe.hpp"

namespace rigsound::analysis {
namespace {

ClickProcess process(double jitter, double amplitude_cv, double amplitude_rho) {
  ClickProcess p;
  p.jitter = jitter, p.amplitude_cv = amplitude_cv, p.amplitude_rho = amplitude_rho;
  return p;
}

/// 35-45 Hz, firm contact: a short attack and a full spectrum.
SituationRecipe normal() {
  return {38,
          42,
          process(.04, .12, .3),
          40,
          1.5,
          25,
          {highpass(90), one_pole(6500), peaking(340, 8, 2), peaking(900, 6, 1.5), peaking(2400, 9, 3),
           peaking(4300, 6, 4)},
          false,
          0,
          1900};
}

/// Weak contact of bit and rock: slow attack, scattered and missing impacts, dull.
SituationRecipe underfeed() {
  ClickProcess p = process(.07, .35, .2);
  p.miss = .125;
  return {35,
          39,
          p,
          150,
          -2,
          20,
          {highpass(80), one_pole(2600), peaking(300, 9, 2), peaking(700, 6, 1.5), peaking(1700, 5, 2)},
          false,
          -4,
          1800};
}

/// Pressed too hard: slower, steadier, damped, and low.
SituationRecipe overfeed() {
  return {34,
          37,
          process(.015, .06, .3),
          60,
          1,
          40,
          {highpass(60), one_pole(3200), peaking(190, 10, 1.5), peaking(480, 8, 2), peaking(1300, 5, 2)},
          false,
          -2,
          2050};
}

/// Loose joints: 18-25 Hz, the rods ring and the piston bounces.
SituationRecipe closed_rattling() {
  ClickProcess p = process(.08, .25, .2);
  p.bounce = Bounce{0.05, 0.10, 0.3, 0.6};
  return {19,
          24,
          p,
          16,
          0,
          14,
          {highpass(150), one_pole(8000), peaking(1250, 10, 6), peaking(2900, 9, 6), peaking(5200, 8, 5)},
          true,
          -1,
          1600};
}

/// No rock at all: a short, very loud and bright burst.
SituationRecipe open_rattling() {
  return {40,
          45,
          process(.06, .2, .3),
          10,
          3,
          16,
          {highpass(700), one_pole(12000), peaking(3400, 10, 4), peaking(6100, 12, 5), peaking(9300, 8, 4)},
          true,
          12,
          1500};
}

}  // namespace

SituationRecipe recipe(Situation situation) {
  switch (situation) {
    case Situation::kUnderfeed:
      return underfeed();
    case Situation::kOverfeed:
      return overfeed();
    case Situation::kClosedRattling:
      return closed_rattling();
    case Situation::kOpenRattling:
      return open_rattling();
    case Situation::kNormal:
      break;
  }
  return normal();
}

}  // namespace rigsound::analysis
