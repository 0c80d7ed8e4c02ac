// The M-channel cosine-modulated filter bank of the harmonic-band wavelet transform (MDCT, sine window).
#pragma once

#include <vector>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::dsp {

/// Orthogonal lapped transform, hop M, window 2M (Princen and Bradley's condition):
///   X[q] = sqrt(2/M) sum_{k<2M} w[k] x[k] cos(pi/M (k + 1/2 + M/2)(q + 1/2)),  w[k] = sin(pi/2M (k + 1/2)).
/// With the sine window a signal of period M puts harmonic h in channels 2h - 1 and 2h and nowhere
/// else. Any M >= 1; a power of two >= 4 costs O(M log M), every other size O(M^2). T is float or double.
template <class T>
class Mdct {
 public:
  explicit Mdct(int M);  ///< Thread: OFF

  int channels() const noexcept { return M_; }

  /// `x`: 2M samples, the second half is the first half of the next call. `X`: M coefficients. Thread: RT.
  void analyse(const T* x, T* X) noexcept;

  /// `overlap`: M samples that the caller keeps between calls, zero at first. `y`: M finished samples, the
  /// hop that began one call earlier. Thread: RT.
  void synthesise(const T* X, T* overlap, T* y) noexcept;

  /// The same in steps, 0 ... steps() - 1 and finish(), for who would rather pay for them at different times:
  /// `X` is the same for each, nothing else is asked of this Mdct in between. Thread: RT.
  int steps() const noexcept { return fast_ ? fft_.stages() + 2 : 1; }
  void step(int number, const T* X) noexcept;
  void finish(T* overlap, T* y) noexcept;

 private:
  // The DCT-IV of `x`, also in place: twisted, transformed, twisted back.
  void dct4(const T* x, T* u) noexcept;
  void twist(const T* x) noexcept;
  void twist_back(T* u) const noexcept;

  int M_;
  bool fast_;
  std::vector<T> window_;                 // 2M
  std::vector<T> matrix_;                 // 2M x M, windowed cosines; empty when fast
  Fft<T> fft_;                            // M/2 points when fast
  std::vector<T> twist_cos_, twist_sin_;  // of the DCT-IV, scaled so that the whole is orthonormal
  std::vector<T> u_, re_, im_;
  std::vector<double> sums_;  // of the direct form: float sums of thousands would cost 20 dB
};

extern template class Mdct<float>;
extern template class Mdct<double>;

}  // namespace rigsound::dsp
