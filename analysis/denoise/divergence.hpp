// How well a factorisation explains a spectrogram.
#pragma once

#include "denoise/factors.hpp"

namespace rigsound::analysis {

/// P/L - ln(P/L) - 1 of every cell, L = W H: bins x frames. Thread: OFF.
Grid itakura_saito(const PowerSpectrogram& power, const Factors& factors);

/// Mean over the bins that hold anything (1e-5 of the loudest) and the frames where `weight` is 1. Thread:
/// OFF.
double mean_divergence(const PowerSpectrogram& power, const Factors& factors, const Eigen::ArrayXf& weight);

}  // namespace rigsound::analysis
