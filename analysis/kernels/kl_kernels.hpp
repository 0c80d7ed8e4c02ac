// The matrix products of Kullback-Leibler NMF, compiled once per instruction set and chosen at run time.
#pragma once

namespace rigsound::analysis {

/// V ~ W H, all column-major: V bins x frames, W bins x words, H words x frames.
struct Factorisation {
  const float* V = nullptr;
  float* W = nullptr;
  float* H = nullptr;
  int bins = 0, frames = 0, words = 0;
};

struct KlKernels {
  const char* name;  ///< instruction set, for reports

  /// H *= W'(V / (W H)) / column sums of W. The quotient never leaves the cache: a tile of frames is
  /// multiplied out, divided and multiplied back before the next one.
  void (*update_activations)(const Factorisation& f);

  /// W *= (V / (W H)) H' / row sums of H, in the same tiles.
  void (*update_words)(const Factorisation& f);

  /// C = A B, n x n: what this machine can do with a product at all, the yardstick of the two above.
  void (*multiply)(const float* A, const float* B, float* C, int n);
};

/// The kernels for the best instruction set of this machine. Thread: OFF, any.
const KlKernels& kl_kernels();

}  // namespace rigsound::analysis
