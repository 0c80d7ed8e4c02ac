// The ceiling: no sample ever exceeds it, and none is late for it.
#pragma once

#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// Peak limiter without latency: it knows one chunk at a time, lets the gain fall ahead of a peak inside
/// that chunk and lets it recover exponentially afterwards. All channels share one gain, so the image
/// stays where it is.
class Limiter {
 public:
  /// `ceiling`: linear, > 0. Thread: OFF.
  Limiter(double ceiling, int channels, double sample_rate) noexcept;

  /// Limits kChunk samples of each channel in place. A sample that is not finite becomes 0.
  /// Shape: channels x kChunk. Thread: RT.
  void process(double (*x)[kChunk]) noexcept;

  double lowest_gain() const noexcept { return lowest_; }  ///< of the last chunk

 private:
  double ceiling_, release_;
  int channels_;
  double gain_ = 1, lowest_ = 1;
};

}  // namespace rigsound::mix
