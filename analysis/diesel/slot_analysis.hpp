// The high layer: variance per slot and band, how it varies from cycle to cycle, and grains (A8, A11).
#pragma once

#include "diesel/section.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound::analysis {

/// Fills v_hi, s2 and rho of `point` from the whitened residual in whole cycles, L slots each. Only frames
/// that are open throughout count. Thread: OFF.
void learn_slots(const CycleBlock& whitened, int L, DieselPoint& point);

/// Keeps `count` cycles spread over the block, scaled together to the power of all. Thread: OFF.
void learn_grains(const CycleBlock& whitened, int count, DieselPoint& point);

}  // namespace rigsound::analysis
