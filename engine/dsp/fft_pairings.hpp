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

/// Each width is compiled in a file of its own; kFour only where there is AVX2. Thread: RT.
template <class T, LaneWidth kWidth>
struct FftPairings {
  static void run(const FftStage<T>& stage, T* re, T* im) noexcept;
};

}  // namespace rigsound::dsp
