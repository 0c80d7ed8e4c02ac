// Reads a layer between its angle samples.
#pragma once

#include <vector>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::diesel {

/// A windowed sinc of 16 taps, tabulated at 256 places between two samples and linear between those; in
/// float: what it reads is exact to -120 dB of the largest sample near by.
class AngleReader {
 public:
  static constexpr int kTaps = 16;
  static constexpr int kFirst = 1 - kTaps / 2;  ///< of the samples read, counted from the one at or before

  struct Weights {
    dsp::FloatLanes w0, w1, w2, w3;
  };

  AngleReader();  ///< Thread: OFF

  /// For the place `fraction`, 0...1, after a sample. Thread: RT.
  Weights weights(double fraction) const noexcept {
    const double position = fraction * kRows;
    const int row = static_cast<int>(position);
    const auto alpha = static_cast<float>(position - row);
    const float *a = rows_.data() + row * kTaps, *b = a + kTaps;
    const auto between = [&](int k) {
      const dsp::FloatLanes from = dsp::load_floats(a + k);
      return from + alpha * (dsp::load_floats(b + k) - from);
    };
    return {between(0), between(4), between(8), between(12)};
  }

  /// What lies there: the four lanes are yet to be added. `x`: kTaps samples, the first of them kFirst from
  /// the one before the place. Thread: RT.
  static dsp::FloatLanes read(const Weights& w, const float* x) noexcept {
    return (w.w0 * dsp::load_floats(x) + w.w1 * dsp::load_floats(x + 4)) +
           (w.w2 * dsp::load_floats(x + 8) + w.w3 * dsp::load_floats(x + 12));
  }

 private:
  static constexpr int kRows = 256;
  std::vector<float> rows_;  // (kRows + 1) x kTaps
};

}  // namespace rigsound::diesel
