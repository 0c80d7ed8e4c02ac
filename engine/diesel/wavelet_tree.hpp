// Streaming synthesis of the discrete wavelet transform for many channels of noise at once.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/dsp/random.hpp"

namespace rigsound::diesel {

/// N-level db4 tree. Channels are dealt to kGroups groups whose trees stand at different phases: the variance
/// of one scale ripples with period 2^n frames, and so it averages out and no frame pays for every level.
class WaveletTree {
 public:
  static constexpr int kGroups = 16;

  /// `channels`: a multiple of 2 kGroups. `N` >= 0. Thread: OFF.
  WaveletTree(int channels, int N, std::uint64_t seed);

  /// The next coefficient of the channels of `group`: channels / kGroups values at out[i], for channel
  /// group + i * kGroups. `deviation` of these: (N + 1) x channels / kGroups, per scale n = 1...N, then the
  /// scaling band.
  /// Thread: RT.
  void produce(int group, const double* deviation, double* out) noexcept;

  void reset() noexcept;  ///< Silence so far. Thread: RT

 private:
  void level(int group, int j, const double* deviation, double* out) noexcept;
  void draw(int row, const double* deviation, double* out) noexcept;

  static constexpr int kPast = 4;  // a coefficient of the parent reaches over four pairs
  int channels_, N_, width_;
  dsp::RandomField random_;
  std::vector<double> approximation_, detail_;  // N x kPast x channels, newest first
  std::vector<std::uint64_t> count_;            // frames made, per group
  std::uint64_t drawn_ = 0;
};

}  // namespace rigsound::diesel
