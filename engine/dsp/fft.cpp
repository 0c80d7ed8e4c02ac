#include "rigsound/dsp/fft.hpp"

#include <cstring>
#include <type_traits>
#include <utility>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

namespace {

template <class T>
using Wide = std::conditional_t<std::is_same_v<T, float>, FloatLanes, Lanes>;
template <class T>
constexpr int kWide = sizeof(Wide<T>) / sizeof(T);

template <class V, class T>
V values_at(const T* p) noexcept {
  V v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

template <class V, class T>
void put_at(T* p, V v) noexcept {
  std::memcpy(p, &v, sizeof v);
}

/// Of one pair of halves; as many side by side as a V holds.
template <class V, int kSideBySide, class T>
void butterflies(T* re, T* im, int half, const T* c, const T* s) noexcept {
  for (int j = 0; j < half; j += kSideBySide) {
    const V r0 = values_at<V>(re + j), i0 = values_at<V>(im + j), r1 = values_at<V>(re + half + j),
            i1 = values_at<V>(im + half + j), cs = values_at<V>(c + j), sn = values_at<V>(s + j);
    const V ur = r1 * cs - i1 * sn, ui = r1 * sn + i1 * cs;
    put_at(re + half + j, V(r0 - ur)), put_at(im + half + j, V(i0 - ui));
    put_at(re + j, V(r0 + ur)), put_at(im + j, V(i0 + ui));
  }
}

}  // namespace

template <class T>
Fft<T>::Fft(int size) : size_(size), reversed_(static_cast<std::size_t>(size)) {
  for (int i = 0, j = 0; i < size; ++i) {
    reversed_[static_cast<std::size_t>(i)] = j;
    int bit = size >> 1;
    for (; bit && (j & bit); bit >>= 1) j ^= bit;
    j |= bit;
  }
  for (int length = 2; length <= size; length *= 2, ++stages_)
    for (int j = 0; j < length / 2; ++j) {
      cos_.push_back(static_cast<T>(cos(kTwoPi * j / length)));
      sin_.push_back(static_cast<T>(-sin(kTwoPi * j / length)));
    }
}

template <class T>
void Fft<T>::put_in_order(T* re, T* im) const noexcept {
  for (int i = 0; i < size_; ++i) {
    const int j = reversed_[static_cast<std::size_t>(i)];
    if (i < j) std::swap(re[i], re[j]), std::swap(im[i], im[j]);
  }
  for (int i = 0; i < size_; i += 2) {  // the first stage turns nothing
    const T r = re[i + 1], q = im[i + 1];
    re[i + 1] = re[i] - r, im[i + 1] = im[i] - q;
    re[i] += r, im[i] += q;
  }
}

template <class T>
void Fft<T>::stage(int number, T* re, T* im) const noexcept {
  if (number == 0) return put_in_order(re, im);
  const int half = 1 << number;
  const T *c = cos_.data() + half - 1, *s = sin_.data() + half - 1;
  for (int start = 0; start < size_; start += 2 * half)
    half < kWide<T> ? butterflies<T, 1>(re + start, im + start, half, c, s)
                    : butterflies<Wide<T>, kWide<T>>(re + start, im + start, half, c, s);
}

template <class T>
void Fft<T>::forward(T* re, T* im) const noexcept {
  for (int number = 0; number < stages_; ++number) stage(number, re, im);
}

template class Fft<float>;
template class Fft<double>;

}  // namespace rigsound::dsp
