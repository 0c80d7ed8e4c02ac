// The fixed activations of step 6: how the energy of a click train reaches the frames.
#pragma once

#include <array>

#include "denoise/factors.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

constexpr int kDecayCount = 6;

/// Decay rates of a dictionary, in 1/T_0, ascending: a click's bins decay at different speeds.
using Decays = std::array<double, kDecayCount>;

/// For a train whose envelope is not to be trusted yet.
constexpr Decays kUsualDecays = {1, 1.6, 2.5, 4, 7, 12};

/// Equal ratios from 0.4 alpha_d T_0 (the slowest mode outlives the common envelope), at least 0.5, to 12. A
/// rate slower than any bin's lets background into the drilling; without one as slow as the slowest bin's,
/// clicks that run into one another are taken for background. Thread: OFF.
Decays decays_around(const ClickTrain& train);

/// Row j, frame n: sum_i beta_i^2 (a_j^2 * w^2)(128 n - P_i), with a_j the linear attack N_a followed by
/// exp(-alpha_j n), alpha_j = decays[j]/T_0, and w the Hann window of kChainStft. Each row has mean 1 over
/// `frames`; columns up to `padded` are zero. Thread: OFF.
Grid click_activations(const ClickTrain& train, const Decays& decays, int frames, int padded);

}  // namespace rigsound::analysis
