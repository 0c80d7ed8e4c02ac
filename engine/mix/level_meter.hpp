// Peak and rms of a signal over a block.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/passes.hpp"
#include "rigsound/engine_view.hpp"

namespace rigsound::mix {

/// Squares in lanes: the peak is the root of the largest. Thread: RT.
class LevelMeter {
 public:
  /// `count` samples; a multiple of 8. False, and none of them counts, when one is not finite or so large
  /// that it is no sound.
  bool add(const double* x, int count) noexcept {
    const auto squares = dsp::with_widest<dsp::Passes>([&](auto passes) { return passes.squares(x, count); });
    if (!(dsp::total(squares.sum) < kNoSound)) return false;
    sum_ += squares.sum;
    most_ = dsp::larger(most_, squares.most);
    return true;
  }

  /// Of `samples` samples, those that were added and zeros, at `gain`; begins anew.
  LayerLevel take(double gain, int samples) noexcept {
    const double most = std::max(most_[0], most_[1]), sum = sum_[0] + sum_[1];
    *this = {};
    return {static_cast<float>(gain * std::sqrt(most)), static_cast<float>(gain * std::sqrt(sum / samples))};
  }

 private:
  static constexpr double kNoSound = 1e60;  // an energy: what sounds stays far below, and can be mixed

  dsp::Lanes sum_{}, most_{};
};

}  // namespace rigsound::mix
