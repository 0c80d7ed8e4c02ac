// The ceiling without latency: no sample passes it, and none is late for it.
#pragma once

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// Peak limiter that knows one chunk at a time: the gain falls ahead of a peak inside that chunk and recovers
/// exponentially afterwards. Both channels share one gain, so the image stays where it is. What lies between
/// the samples may pass the ceiling: LookaheadLimiter.
class Limiter {
 public:
  /// `ceiling`: linear, > 0. Thread: OFF.
  Limiter(double ceiling, double sample_rate) noexcept;

  /// Limits kChunk frames of two channels in place; costs one look at each sample while it has nothing to do.
  /// Thread: RT.
  void process(dsp::Lanes* x) noexcept;

  double lowest_gain() const noexcept { return lowest_; }  ///< of the last chunk

 private:
  void limit(const double* allowed, dsp::Lanes* x) noexcept;

  double ceiling_, release_;
  double gain_ = 1, lowest_ = 1;
};

}  // namespace rigsound::mix
