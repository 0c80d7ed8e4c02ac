// The crank angle of a chunk, sample by sample.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {

/// Where each sample of a chunk lies among the angle samples of one layer.
struct AngleSpan {
  std::int64_t base = 0;                ///< angle sample at or before the chunk's first frame
  std::array<int, kChunk> offset;       ///< whole angle samples past base
  std::array<double, kChunk> fraction;  ///< 0...1
  int count = 0;                        ///< offset of the last frame + 1
};

class Crank {
 public:
  /// Turns through one chunk; speed goes linearly from `f_from` to `f_to` cycles a second. Thread: RT.
  void turn(double f_from, double f_to, double sample_rate) noexcept {
    const double rise = (f_to - f_from) / (kChunk * sample_rate);
    double step = f_from / sample_rate + 0.5 * rise;  // cycles from one sample to the next
    for (double& angle : angle_) {
      angle = next_;
      next_ += step;
      step += rise;
    }
    first_cycle_ = cycle_;
    const double whole = std::floor(next_);
    cycle_ += static_cast<std::int64_t>(whole);
    next_ -= whole;
  }

  /// The same angles in units of 1 / `samples` of a cycle. Thread: RT.
  void span(int samples, AngleSpan& span) const noexcept {
    const double start = std::floor(angle_[0] * samples);
    span.base = first_cycle_ * samples + static_cast<std::int64_t>(start);
    for (std::size_t n = 0; n < kChunk; ++n) {
      const double at = angle_[n] * samples - start;
      span.offset[n] = static_cast<int>(at);  // never before the start
      span.fraction[n] = at - span.offset[n];
    }
    span.count = span.offset[kChunk - 1] + 1;
  }

 private:
  std::array<double, kChunk> angle_{};  // cycles past first_cycle_
  double next_ = 0;                     // 0...1
  std::int64_t cycle_ = 0, first_cycle_ = 0;
};

}  // namespace rigsound::diesel
