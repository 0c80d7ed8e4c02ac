// The low layer: energy of every sideband channel and wavelet scale (A6).
#pragma once

#include "diesel/section.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound::analysis {

/// Fills v_lo of `point`: (N + 1) x P_lo variances of the residual's coefficients, edges left out, the
/// missing degree of freedom of the mean cycle restored. Thread: OFF.
void learn_low_layer(const CycleBlock& residual, int P_lo, int N, DieselPoint& point);

/// Share of the residual's power under `f_x` that is left when the impacts are gated out, 0...1, in bands
/// an octave wide, applied to v_lo. Clean sections are left as they are. Thread: OFF.
void gate_low_layer(const Section& section, const std::vector<double>& residual, double f_x, int P_lo,
                    DieselPoint& point);

}  // namespace rigsound::analysis
