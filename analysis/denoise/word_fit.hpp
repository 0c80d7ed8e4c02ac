// The words of a factorisation learned for given activations, kLanes bins at a time.
#pragma once

#include <iterator>
#include <vector>

#include "denoise/factors.hpp"
#include "kernels/is_kernels.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

constexpr float kPlainExponent[] = {1};
/// An update leaves 1 - exponent e of a deviation, with e from near 0 (between words that resemble one
/// another) to 1 (of their sum). The large exponents speed up the former; the ones hold the latter down,
/// which the large ones blow up.
constexpr float kFastExponents[] = {1, 1, 1, 1, 2, 4, 8, 16};

/// `count` updates of exponent 1.
constexpr Updates plain_updates(int count) { return {kPlainExponent, 1, count}; }

/// `rounds` of all exponents, each of which comes about as far as 34 plain updates, but nowhere by the same
/// way.
constexpr Updates fast_updates(int rounds) {
  constexpr int kRound = std::size(kFastExponents);
  return {kFastExponents, kRound, kRound * rounds};
}

/// A power spectrogram laid out for the kernels. Thread: OFF.
class WordFit {
 public:
  explicit WordFit(const PowerSpectrogram& power);

  /// Updates every row of f.W; f.H stays. `cost` of each word, null: 1.
  void update(const Updates& updates, const float* cost, Factors& f) const;

 private:
  int frames_, bins_;
  std::vector<float> side_by_side_;  // of kLanes bins frames x kLanes, then of the next
};

}  // namespace rigsound::analysis
