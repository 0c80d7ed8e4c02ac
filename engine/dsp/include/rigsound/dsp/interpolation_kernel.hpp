// Reads a sampled signal between its samples: windowed sinc, tabulated, linear between the table's rows.
#pragma once

#include <vector>

namespace rigsound::dsp {

/// Kaiser-windowed sinc. 16 taps with beta 8 and 256 phases: error -88 dB for white content up to a quarter
/// of the sampling rate; 32 taps with beta 10 up to 0.4 of it.
class InterpolationKernel {
 public:
  /// `taps`: a multiple of 8. `phases`: rows of the table. `cut`: pass band relative to half the rate, 0...1.
  /// Thread: OFF.
  InterpolationKernel(int taps, int phases, double beta, double cut = 1.0);

  int taps() const noexcept { return taps_; }

  /// The value at position i + fraction (0 <= fraction < 1) is sum_k w[k] x[i + first() + k]. Thread: RT.
  void weights(double fraction, double* w) const noexcept;
  int first() const noexcept { return 1 - taps_ / 2; }

 private:
  int taps_, phases_;
  std::vector<double> rows_;  // (phases + 1) x taps
};

}  // namespace rigsound::dsp
