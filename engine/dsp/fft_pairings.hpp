// The inner loops of the FFT, once per vector width: the same bits at each.
#pragma once

#include "rigsound/dsp/lane_width.hpp"

namespace rigsound::dsp {

template <class T>
struct FftStage {
  int size, half;      ///< of the transform, of the pairs
  bool last;           ///< one pairing instead of two
  const T *cos, *sin;  ///< twiddles from this pairing on
};

/// Taken by with_widest<FftPairings>(). Thread: RT.
template <LaneWidth kWidth>
struct FftPairings {
  static void run(const FftStage<float>& stage, float* re, float* im) noexcept;
  static void run(const FftStage<double>& stage, double* re, double* im) noexcept;
};

}  // namespace rigsound::dsp
