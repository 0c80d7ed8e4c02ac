// Noise for every subband of a note at once, which the transform finds where it was meant to be.
#pragma once

#include <random>
#include <vector>

#include "diesel/hbwt.hpp"
#include "note/subband_noise.hpp"

namespace rigsound::analysis {

/// How power lies within one subband of one channel: an all-pole spectrum.
struct SubbandSpectrum {
  double variance = 0;                  ///< of its coefficients
  std::vector<double> predictor = {1};  ///< 1, a_1 ... a_p; its alone: white
  double gain = 1;                      ///< of the all-pole spectrum whose mean is 1

  /// `angle`: rad a coefficient, 0...pi.
  double density(double angle) const;
};

/// That of `d`, white where it holds fewer than 4 coefficients an order. Thread: OFF.
SubbandSpectrum subband_spectrum(const Subband& d, double variance, int order);

/// wanted[n - 1][q] for channel q: scales n = 1...N, then the scaling band.
using FieldSpectra = std::vector<std::vector<SubbandSpectrum>>;

/// The transform (L = 1) of `length` samples of Gaussian noise with these spectra. One stationary noise has
/// coefficients that cancel wherever channels and scales overlap; drawn one by one they add up there, 20 dB
/// over the weak subbands beside a strong one. Thread: OFF.
HbwtCoefficients<double> noise_field(const HbwtShape& shape, int length, const FieldSpectra& wanted,
                                     std::mt19937_64& chance);

}  // namespace rigsound::analysis
