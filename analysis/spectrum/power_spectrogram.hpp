// Power spectrograms as the factorisations take them: normalised, floored, padded for the kernels.
#pragma once

#include "spectrum/stft.hpp"

namespace rigsound::analysis {

/// |X|^2 over its mean, never below a floor; `frames` columns hold data, the rest up to a multiple of
/// kLanes are zero.
struct PowerSpectrogram {
  Grid P;  ///< bins x padded frames
  int frames = 0;
  double scale = 1;  ///< the mean that was divided out

  int bins() const { return static_cast<int>(P.rows()); }
  int padded() const { return static_cast<int>(P.cols()); }
};

/// Thread: OFF.
PowerSpectrogram power_spectrogram(const Spectrogram& X);

/// Frames [first, last) of it, in the same units. Thread: OFF.
PowerSpectrogram frames_between(const PowerSpectrogram& power, int first, int last);

/// Of every bin over time, in the units of P. Thread: OFF.
Eigen::ArrayXd mean_power(const PowerSpectrogram& power);

/// What Gaussian noise of exactly the modelled power leaves of its Itakura-Saito divergence on average, per
/// cell: Euler's constant.
constexpr double kNoiseDivergence = 0.5772156649;

}  // namespace rigsound::analysis
