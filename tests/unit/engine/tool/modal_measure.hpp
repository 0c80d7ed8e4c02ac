// Modes measured in a sound, and sounds made of modes: the oracle against which the bar's loops are held.
#pragma once

#include <complex>
#include <vector>

#include "rigsound/tool_design.hpp"

namespace rigsound::tests {

struct MeasuredMode {
  double omega = 0;  ///< rad/sample
  double sigma = 0;  ///< ln of the amplitude ratio from one sample to the next
};

/// Every decaying oscillation in `sound`, which must be a sum of at most `order` exponentials: least-squares
/// linear prediction, roots of its polynomial. Looks at every `every`th sample, which spreads low modes
/// apart; modes above the lower rate's half fold down, as exponentials do.
std::vector<MeasuredMode> measure_modes(const std::vector<double>& sound, int order, int every);

/// The measured mode nearest `omega`.
MeasuredMode nearest(const std::vector<MeasuredMode>& modes, double omega);

/// Modal bank: impulse response of y = x + k F A z^-N y as the sum over all poles of residue * pole^n. Poles
/// and residues come from the loop's polynomials, written out here from the definition of its parts.
std::vector<double> modal_bank(const LoopDesign& loop, double k, int samples);

}  // namespace rigsound::tests
