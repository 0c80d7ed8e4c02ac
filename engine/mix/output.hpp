// The last step: gain, ceiling, single precision, all channels, and what was played.
#pragma once

#include "mix/gain_curve.hpp"
#include "rigsound/dsp/lanes.hpp"
#include "rigsound/engine_view.hpp"

namespace rigsound::mix {

/// Sounds are on the first two channels, or on the only one; the others are silent. Thread: RT.
class Output {
 public:
  /// `ceiling`: linear; no sample is over it. Thread: OFF.
  Output(double ceiling, int channels) noexcept
      : ceiling_(static_cast<float>(ceiling)), channels_(channels) {}

  /// kChunk frames times `gain`, to kChunk x channels samples, interleaved.
  void write(const dsp::Lanes* x, const GainCurve& gain, float* out) noexcept;
  void write_silence(float* out) noexcept;

  /// Of a block of `samples`, those written and silence; begins anew.
  LayerLevel take(int samples) noexcept;

 private:
  float ceiling_;
  int channels_;
  dsp::Lanes energy_{}, most_{};  ///< most_: squared
};

}  // namespace rigsound::mix
