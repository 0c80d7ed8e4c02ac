// Peak and rms of a layer over a block.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rigsound/engine_view.hpp"

namespace rigsound::mix {

/// Four sums side by side, so that a compiler may take them at once without changing the order. Thread: RT.
class LevelMeter {
 public:
  /// kChunk samples.
  void add(const double* x) noexcept {
    for (int n = 0; n < kChunk; n += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) {
        const double square = x[n + lane] * x[n + lane];
        sum_[lane] += square;
        most_[lane] = square > most_[lane] ? square : most_[lane];
      }
  }

  /// Of `samples` samples, those that were added and zeros, at `gain`; begins anew.
  LayerLevel take(double gain, int samples) noexcept {
    const double most = std::max(std::max(most_[0], most_[1]), std::max(most_[2], most_[3]));
    const double sum = (sum_[0] + sum_[1]) + (sum_[2] + sum_[3]);
    *this = {};
    return {static_cast<float>(gain * std::sqrt(most)), static_cast<float>(gain * std::sqrt(sum / samples))};
  }

 private:
  static constexpr int kLanes = 4;

  std::array<double, kLanes> sum_{}, most_{};
};

}  // namespace rigsound::mix
