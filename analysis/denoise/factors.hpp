// A power spectrogram as the product of words and activations: start, model, divergence.
#pragma once

#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

/// No entry of a word is fitted below this: an exact zero could never rise again.
constexpr float kWordFloor = 1e-10f;

/// `knots` hat functions that sum to 1 over `frames` (a slow noise's course in time), padded with zeros
/// to `padded` columns. Thread: OFF.
Grid hats(int knots, int frames, int padded);

/// The powers a factorisation found in each cell, in the units of |X|^2.
struct PsdPair {
  Grid S;  ///< drilling, bins x frames
  Grid N;  ///< background, bins x frames
};

/// The factorisation W H of a power spectrogram: the first `signal_words` columns of W and rows of H are
/// the drilling's.
struct Factors {
  Grid W;  ///< bins x K
  Grid H;  ///< K x padded frames
  int signal_words = 0;
};

/// Thread: OFF.
PsdPair modelled_psd(const Factors& factors, const PowerSpectrogram& power);

/// Means of both over time, a bin. Thread: OFF.
struct MeanPsd {
  Eigen::ArrayXd S, N;
};
MeanPsd mean_psd(const Factors& factors, const PowerSpectrogram& power);

/// G X with the Wiener gain G = S / (S + N), times S G / (S G + c) with c a hundredth of its bin's mean error
/// S N / (S + N): cells that hold next to nothing of the drilling are silenced. The expected error of a bin
/// rises by a quarter of a per cent at most. Thread: OFF.
Spectrogram wiener(const Spectrogram& X, const PsdPair& psd);

/// P/L - ln(P/L) - 1 of every cell, L = W H: bins x frames. Thread: OFF.
Grid itakura_saito(const PowerSpectrogram& power, const Factors& factors);

/// Mean of `divergence` over the frames where `weight` is 1, one for each of those of the lowest `bins` bins
/// that hold anything (1e-5 of the loudest). Thread: OFF.
Eigen::ArrayXd divergence_by_bin(const PowerSpectrogram& power, const Grid& divergence,
                                 const Eigen::ArrayXf& weight, long bins);

}  // namespace rigsound::analysis
