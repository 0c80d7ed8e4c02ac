// The harmonic-band wavelet transform, with L slots a period: M-channel MDCT, then db4 across periods.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// P = M * L samples a period, N wavelet scales. L = 1 is the paper's transform, L = P the multiplexed
/// wavelet transform of its reference [3].
struct HbwtShape {
  int P = 0;
  int L = 1;
  int N = 4;
  int M() const { return P / L; }
};

/// Column c = l * M + q is channel q of slot l. Channel 2h - 1 holds the lower, 2h the upper sideband of
/// harmonic h (L = 1). Scale n = 1 is the finest: 1/4...1/2 of the fundamental away from the harmonic.
template <class T>
struct HbwtCoefficients {
  HbwtShape shape;
  int length = 0;                 ///< samples of the signal
  int frames = 0;                 ///< R, frames a column before the DWT, a multiple of 2^N
  std::vector<std::vector<T>> d;  ///< d[n - 1]: (R >> n) x P, row by row
  std::vector<T> a;               ///< scaling coefficients, (R >> N) x P
};

/// Any length, any P = M * L; the end is padded by repeating the last period. T is float or double.
/// Thread: OFF.
template <class T>
HbwtCoefficients<T> hbwt(const std::vector<T>& x, const HbwtShape& shape);

/// Its exact inverse, `length` samples. Thread: OFF.
template <class T>
std::vector<T> inverse_hbwt(const HbwtCoefficients<T>& c);

/// The MDCT frames alone: (frames + 1) x M for frames = length / M, zeros assumed on both sides. Thread: OFF.
template <class T>
std::vector<T> mdct_frames(const std::vector<T>& x, int M);

/// Overlap-add of `frames` x M coefficients: (frames - 1) * M samples. Thread: OFF.
template <class T>
std::vector<T> from_mdct_frames(const std::vector<T>& X, int M);

}  // namespace rigsound::analysis
