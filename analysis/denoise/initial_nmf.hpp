// Step 1: a first split into impulsive sound and slow background, without any other knowledge.
#pragma once

#include "denoise/word_fit.hpp"

namespace rigsound::analysis {

struct InitialNmfOptions {
  int signal_words = 2;  ///< K_s
  int noise_knots = 2;   ///< hat functions over the clip: they replace smoothing filter and SNR constraint
  int iterations = 80;
  float exponent = 0.7f;     ///< of the multiplicative updates; 0.5 is monotone (majorisation-minimisation)
  float noise_start = 0.5f;  ///< of the 20 % quantile's noise level
  unsigned seed = 0;         ///< of the random start
};

/// Minimises the Itakura-Saito divergence D(P | W_s H_s + W_n hats) over W_s, H_s, W_n by multiplicative
/// updates. The first signal_words rows of H are learned, the hats stay. Thread: OFF.
Factors initial_nmf(const WordFit& clip, const InitialNmfOptions& options);

}  // namespace rigsound::analysis
