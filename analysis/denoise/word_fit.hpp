// The words of a factorisation learned for given activations, kLanes bins at a time.
#pragma once

#include <Eigen/Core>
#include <iterator>

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

/// What every factorisation of one power spectrogram needs: laid out for the kernels, with its levels.
/// Thread: OFF.
class WordFit {
 public:
  /// `power` must outlive it.
  explicit WordFit(const PowerSpectrogram& power);

  const PowerSpectrogram& power() const { return *power_; }

  /// The mean power of each bin.
  const Eigen::ArrayXf& mean() const { return mean_; }

  /// `start` times the level of a stationary noise in each bin, from the 20 % quantile over time: the power
  /// of Gaussian noise is exponentially distributed, so that quantile is -ln(0.8) = 0.223 of its mean. Never
  /// above 0.9 of the bin's mean.
  Eigen::ArrayXf noise(float start) const { return (start * quiet_).min(0.9f * mean_); }

  /// Updates every row of f.W; f.H stays. `cost` of each word, null: 1.
  void update(const Updates& updates, const float* cost, Factors& f) const;

 private:
  const PowerSpectrogram* power_;
  Eigen::ArrayXf mean_, quiet_;
  Eigen::ArrayXf side_by_side_;  // of kLanes bins frames x kLanes, then of the next
};

}  // namespace rigsound::analysis
