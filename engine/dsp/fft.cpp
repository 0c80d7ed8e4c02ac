#include "rigsound/dsp/fft.hpp"

#include <utility>

#include "fft_pairings.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

template <class T>
Fft<T>::Fft(int size) : size_(size) {
  const auto half = static_cast<std::size_t>(size / 2);
  swaps_.reserve(half);
  for (int i = 0, j = 0; i < size; ++i) {
    if (i < j) swaps_.push_back({i, j});
    int bit = size >> 1;
    for (; bit && (j & bit); bit >>= 1) j ^= bit;
    j |= bit;
  }
  if (size == 1) return;
  cos_.resize(2 * half - 1), sin_.resize(2 * half - 1);
  for (std::size_t j = 0; j < half; ++j) {
    const SinCos turn = sin_cos(kTwoPi * static_cast<double>(j) / size);
    cos_[half - 1 + j] = static_cast<T>(turn.cos), sin_[half - 1 + j] = static_cast<T>(-turn.sin);
  }
  for (std::size_t i = half - 1; i-- > 0;)  // half the angles of the stage above
    cos_[i] = cos_[2 * i + 1], sin_[i] = sin_[2 * i + 1];
  stages_ = 1;
  for (int done = 2; done < size; done *= 4) ++stages_;
}

template <class T>
void Fft<T>::put_in_order(T* re, T* im) const noexcept {
  for (const auto& [i, j] : swaps_) std::swap(re[i], re[j]), std::swap(im[i], im[j]);
  for (int i = 0; i < size_; i += 2) {  // the first stage turns nothing
    const T r = re[i + 1], q = im[i + 1];
    re[i + 1] = re[i] - r, im[i + 1] = im[i] - q;
    re[i] += r, im[i] += q;
  }
}

template <class T>
void Fft<T>::stage(int number, T* re, T* im) const noexcept {
  if (number == 0) return put_in_order(re, im);
  const int half = 1 << (2 * number - 1);
  const T *c = cos_.data() + half - 1, *s = sin_.data() + half - 1;
  const FftStage<T> pairings{size_, half, 2 * half == size_, c, s};
  with_widest<FftPairings>([&](auto kernels) { kernels.run(pairings, re, im); });
}

template <class T>
void Fft<T>::forward(T* re, T* im) const noexcept {
  for (int number = 0; number < stages_; ++number) stage(number, re, im);
}

template class Fft<float>;
template class Fft<double>;

}  // namespace rigsound::dsp
