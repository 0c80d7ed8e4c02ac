// Mean power spectrum of a few windows of a sound.
#pragma once

#include <vector>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {

/// About 21 ms of samples, a power of two: clicks at 40 Hz stay apart.
int short_window(int rate);

/// Hann windows; a sine of amplitude 1 leaves a power of 1 in its bin. Thread: OFF, one at a time.
class WindowPower {
 public:
  explicit WindowPower(int length);  ///< samples, a power of two

  int length() const { return fft_.size(); }

  void clear();
  /// Adds `share` of the power of `length` samples.
  void add(const float* x, double share);

  /// length / 2 bins.
  const std::vector<double>& power() const { return power_; }

  /// Between two places on the axis of bins, or, where bins are wider than that, between two bins.
  double between(double from, double to) const;

 private:
  dsp::Fft<float> fft_;
  std::vector<float> window_, re_, im_;
  std::vector<double> power_;
};

}  // namespace rigsound::analysis
