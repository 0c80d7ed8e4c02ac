// The inner loops of Itakura-Saito NMF, compiled once per instruction set and chosen at run time.
// The order of every addition is written down (kLanes partial sums) and nothing is fused, so every
// instruction set gives the same bits.
#pragma once

namespace rigsound::analysis {

constexpr int kLanes = 16;         ///< floats per step; rows are padded with zeros to a multiple
constexpr int kMaxWords = 16;      ///< largest K
constexpr float kLargestStep = 8;  ///< of one update whose exponent is above 1

/// `words` rows of H, each `frames` long (a multiple of kLanes), one after another.
struct Activations {
  const float* H = nullptr;
  int words = 0;
  int frames = 0;
  const float* cost = nullptr;  ///< of each word: fit_bins multiplies its denominator by it; null: 1
};

/// Neighbouring bins of a power spectrogram, side by side, and the powers of their words.
struct BinGroup {
  const float* P = nullptr;  ///< frames x kLanes
  int frames = 0;            ///< as many of H's columns count
  float* W = nullptr;        ///< rows of as many floats as there are words, one after another
  int count = 0;             ///< rows of W, 1 ... kLanes
};

/// A power spectrogram, bin after bin, and the powers of its words.
struct PowerRows {
  const float* P = nullptr;  ///< rows as long as those of H
  const float* W = nullptr;  ///< rows of as many floats as there are words
  int bins = 0;
};

/// Multiplicative updates: the exponent of update i is exponents[i % period], a power of two or below 1.
struct Updates {
  const float* exponents = nullptr;
  int period = 0, count = 0;
};

struct IsKernels {
  const char* name;  ///< instruction set, for reports

  /// Updates w_k *= (sum_n P h_k / L^2 / sum_n h_k / L)^exponent, L = w H, of the words' powers in several
  /// bins, never below `floor`; with an exponent above 1 by kLargestStep at most.
  void (*fit_bins)(const BinGroup& bins, const Activations& H, const Updates& updates, float floor);

  /// The sums of the activation update over the bins in their order, for the first `updated` rows of H:
  /// numerator(k, n) = sum w_k P / L^2, denominator(k, n) = sum w_k / L.
  void (*sum_over_bins)(const PowerRows& power, const Activations& H, int updated, float* numerator,
                        float* denominator);

  /// d(n) = P / L - ln(P / L) - 1 of positive, normal ratios; `size` is a multiple of kLanes.
  void (*divergence)(const float* P, const float* L, int size, float* d);

  /// model(n) = sum over the first `words` of w_k H(k, n).
  void (*model_bin)(const Activations& H, const float* w, int words, float* model);
};

/// The kernels for the best instruction set of this machine. Thread: OFF, any.
const IsKernels& is_kernels();

}  // namespace rigsound::analysis
