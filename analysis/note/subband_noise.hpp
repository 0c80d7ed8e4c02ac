// Noise in the place of wavelet coefficients: the paper's four ways of saying how.
#pragma once

#include <random>
#include <vector>

#include "rigsound/dsp/linear_prediction.hpp"

namespace rigsound::analysis {

/// One channel of one scale, as it was.
using Subband = std::vector<double>;

double power_of(const Subband& d);

/// The 1/f law of section 3 for one channel: log2 variance_n = level + gamma n over scales n = 1...N.
struct OneOverF {
  double level = 0, gamma = 0;
  double variance(int n) const;
};

/// Least squares with weights 2^-n, the number of coefficients a scale has. Thread: OFF.
OneOverF fit_one_over_f(const std::vector<double>& variances);

struct NoiseShape {
  double variance = 0;
  int order = 0;   ///< of the AR filter; 0: white
  int window = 0;  ///< coefficients that share an energy; 0: all
};

/// Takes the mean out of `d` and returns it. Thread: OFF.
double take_mean(Subband& d);

/// All-pole model of `order` from the autocorrelation of `d`. Thread: OFF.
dsp::LinearPrediction prediction_of(const Subband& d, int order);

/// As many coefficients as `original`, Gaussian, of the variance given, coloured by its autocorrelation and
/// following its energy. Thread: OFF.
Subband noise_like(const Subband& original, const NoiseShape& shape, std::mt19937_64& chance);

/// `noise` with the energies that `original` has in windows of `window` coefficients, over its mean; 0: as it
/// is. Thread: OFF.
Subband with_energy_of(const Subband& original, Subband noise, int window);

/// `noise` without its mean and with the power of `original`. Thread: OFF.
Subband as_strong_as(const Subband& original, Subband noise);

}  // namespace rigsound::analysis
