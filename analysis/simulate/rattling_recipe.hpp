// How the simulated machine sounds while rattling, where no law of the feed holds.
#pragma once

#include "rigsound/machine/situation.hpp"
#include "simulate/click_voice.hpp"

namespace rigsound::analysis {

struct RattlingRecipe {
  double rate_low_hz, rate_high_hz;  ///< the rate of a recording is drawn between these
  ClickProcess process;              ///< F0 is set when a recording is made
  double attack_samples, bend;       ///< attack in samples, alpha_a N_a
  double decay_db;                   ///< per period
  BiquadCascade colour;
  double level_db;  ///< RMS against normal drilling
  double rpm;       ///< r/min of the diesel
};

/// Of closed or open rattling.
RattlingRecipe rattling_recipe(Situation situation);

}  // namespace rigsound::analysis
