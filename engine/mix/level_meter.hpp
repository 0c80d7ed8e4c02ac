// Peak and rms of a signal over a block.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/engine_view.hpp"

namespace rigsound::mix {

/// Squares in lanes: the peak is the root of the largest. Thread: RT.
class LevelMeter {
 public:
  /// `count` samples, float or double; a multiple of 8. False, and none of them counts, when one is not
  /// finite or so large that it is no sound.
  template <class Sample>
  bool add(const Sample* x, int count) noexcept {
    dsp::Lanes s0{}, s1{}, s2{}, s3{}, m0{}, m1{}, m2{}, m3{};
    for (int n = 0; n < count; n += 8) {
      take_pair(dsp::load(x + n), s0, m0);
      take_pair(dsp::load(x + n + 2), s1, m1);
      take_pair(dsp::load(x + n + 4), s2, m2);
      take_pair(dsp::load(x + n + 6), s3, m3);
    }
    const dsp::Lanes sum = (s0 + s1) + (s2 + s3);
    if (!(sum[0] + sum[1] < kNoSound)) return false;
    sum_ += sum;
    most_ = dsp::larger(most_, dsp::larger(dsp::larger(m0, m1), dsp::larger(m2, m3)));
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

  static void take_pair(dsp::Lanes x, dsp::Lanes& sum, dsp::Lanes& most) noexcept {
    const dsp::Lanes square = x * x;
    sum += square;
    most = dsp::larger(most, square);
  }

  dsp::Lanes sum_{}, most_{};
};

}  // namespace rigsound::mix
