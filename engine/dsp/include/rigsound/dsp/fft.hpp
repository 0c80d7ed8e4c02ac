// Complex FFT of a power-of-two size with a written order of additions.
#pragma once

#include <array>
#include <vector>

namespace rigsound::dsp {

/// Decimation in time, radix 2, real and imaginary parts in separate arrays. T is float or double.
/// Twiddles come from dsp/elementary, so the bits are the same on every machine.
template <class T>
class Fft {
 public:
  /// `size`: a power of two >= 1. Thread: OFF.
  explicit Fft(int size);

  int size() const noexcept { return size_; }

  /// X[k] = sum_n x[n] exp(-2 pi i n k / size), in place. Thread: RT.
  void forward(T* re, T* im) const noexcept;

  /// forward() is its stages, 0 ... stages() - 1, one after the other. Thread: RT.
  int stages() const noexcept { return stages_; }
  void stage(int number, T* re, T* im) const noexcept;

  /// x[n] = sum_k X[k] exp(+2 pi i n k / size), in place, not divided by the size. Thread: RT.
  void inverse(T* re, T* im) const noexcept { forward(im, re); }

 private:
  void put_in_order(T* re, T* im) const noexcept;

  int size_, stages_ = 0;                  // of the order and the first pairs, then two pairings each
  std::vector<std::array<int, 2>> swaps_;  // of each index with the bit-reversed one
  std::vector<T> cos_, sin_;               // twiddles of every stage, one stage after the other
};

extern template class Fft<float>;
extern template class Fft<double>;

}  // namespace rigsound::dsp
