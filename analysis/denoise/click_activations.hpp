// The fixed activations of step 6: how the energy of a click train reaches the frames.
#pragma once

#include <vector>

#include "denoise/power.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// Decay rates of the dictionary, in 1/T_0: a click's bins decay at different speeds.
constexpr double kDecays[] = {1, 1.6, 2.5, 4, 7, 12};
constexpr int kDecayCount = 6;

/// Row j, frame n: sum_i beta_i^2 (a_j^2 * w^2)(128 n - P_i), with a_j the linear attack N_a followed by
/// exp(-alpha_j n), alpha_j = kDecays[j]/T_0, and w the Hann window of kChainStft. Each row has mean 1 over
/// `frames`; columns up to `padded` are zero. Thread: OFF.
Grid click_activations(const ClickTrain& train, int frames, int padded);

}  // namespace rigsound::analysis
