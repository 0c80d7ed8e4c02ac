#include "rigsound/dsp/fft.hpp"

#include <utility>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

template <class T>
Fft<T>::Fft(int size) : size_(size), reversed_(static_cast<std::size_t>(size)) {
  for (int i = 0, j = 0; i < size; ++i) {
    reversed_[static_cast<std::size_t>(i)] = j;
    int bit = size >> 1;
    for (; bit && (j & bit); bit >>= 1) j ^= bit;
    j |= bit;
  }
  for (int length = 2; length <= size; length *= 2)
    for (int j = 0; j < length / 2; ++j) {
      cos_.push_back(static_cast<T>(cos(kTwoPi * j / length)));
      sin_.push_back(static_cast<T>(-sin(kTwoPi * j / length)));
    }
}

template <class T>
void Fft<T>::forward(T* re, T* im) const noexcept {
  for (int i = 0; i < size_; ++i) {
    const int j = reversed_[static_cast<std::size_t>(i)];
    if (i < j) std::swap(re[i], re[j]), std::swap(im[i], im[j]);
  }
  const T* c = cos_.data();
  const T* s = sin_.data();
  for (int half = 1; half < size_; c += half, s += half, half *= 2)
    for (int start = 0; start < size_; start += 2 * half) {
      T *r0 = re + start, *i0 = im + start, *r1 = r0 + half, *i1 = i0 + half;
      for (int j = 0; j < half; ++j) {
        const T ur = r1[j] * c[j] - i1[j] * s[j];
        const T ui = r1[j] * s[j] + i1[j] * c[j];
        r1[j] = r0[j] - ur, i1[j] = i0[j] - ui;
        r0[j] += ur, i0[j] += ui;
      }
    }
}

template class Fft<float>;
template class Fft<double>;

}  // namespace rigsound::dsp
