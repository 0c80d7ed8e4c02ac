// The inner loops of Itakura-Saito NMF, compiled once per instruction set and chosen at run time.
// The order of every addition is written down (kLanes partial sums) and nothing is fused, so every
// instruction set gives the same bits.
#pragma once

namespace rigsound::analysis {

constexpr int kLanes = 16;     ///< floats per step; rows are padded with zeros to a multiple
constexpr int kMaxWords = 16;  ///< largest K

/// `words` rows of H, each `frames` long (a multiple of kLanes), one after another.
struct Activations {
  const float* H = nullptr;
  int words = 0;
  int frames = 0;
  const float* cost = nullptr;  ///< of each word: fit_bin multiplies its denominator by it; null: 1
};

struct IsKernels {
  const char* name;  ///< instruction set, for reports

  /// `iterations` multiplicative updates w_k *= (sum_n P h_k / L^2 / sum_n h_k / L)^exponent, L = w H, of the
  /// words' powers in one bin, never below `floor`. P: the bin's power in each frame.
  void (*fit_bin)(const float* P, const Activations& H, float* w, int iterations, float exponent,
                  float floor);

  /// Adds one bin's share to the sums of the activation update, for the first `updated` rows of H:
  /// numerator(k, n) += w_k P / L^2, denominator(k, n) += w_k / L.
  void (*add_activation_terms)(const float* P, const Activations& H, const float* w, int updated,
                               float* numerator, float* denominator);

  /// model(n) = sum over the first `words` of w_k H(k, n).
  void (*model_bin)(const Activations& H, const float* w, int words, float* model);
};

/// The kernels for the best instruction set of this machine. Thread: OFF, any.
const IsKernels& is_kernels();

}  // namespace rigsound::analysis
