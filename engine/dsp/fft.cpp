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

/// As many complex numbers side by side as a V holds.
template <class V>
struct ComplexValues {
  V re, im;
};

template <class V, class T>
ComplexValues<V> numbers_at(const T* re, const T* im) noexcept {
  return {values_at<V>(re), values_at<V>(im)};
}

template <class V, class T>
void put_numbers_at(T* re, T* im, const ComplexValues<V>& x) noexcept {
  put_at(re, x.re), put_at(im, x.im);
}

/// a and b become a + w b and a - w b.
template <class V>
void turn(ComplexValues<V>& a, ComplexValues<V>& b, const ComplexValues<V>& w) noexcept {
  const V re = b.re * w.re - b.im * w.im, im = b.re * w.im + b.im * w.re;
  b = {a.re - re, a.im - im};
  a = {a.re + re, a.im + im};
}

/// Of one pair of halves.
template <class V, int kSideBySide, class T>
void butterflies(T* re, T* im, int half, const T* c, const T* s) noexcept {
  for (int j = 0; j < half; j += kSideBySide) {
    auto x0 = numbers_at<V>(re + j, im + j), x1 = numbers_at<V>(re + half + j, im + half + j);
    turn(x0, x1, numbers_at<V>(c + j, s + j));
    put_numbers_at(re + half + j, im + half + j, x1), put_numbers_at(re + j, im + j, x0);
  }
}

/// Of two pairs, then of their own pair: half the loads and stores of one after the other.
template <class V, int kSideBySide, class T>
void double_butterflies(T* re, T* im, int half, const T* c, const T* s) noexcept {
  const T *next_c = c + half, *next_s = s + half;
  for (int j = 0; j < half; j += kSideBySide) {
    const auto at = [&](int quarter) {
      return numbers_at<V>(re + quarter * half + j, im + quarter * half + j);
    };
    const auto put = [&](int quarter, const ComplexValues<V>& x) {
      put_numbers_at(re + quarter * half + j, im + quarter * half + j, x);
    };
    auto x0 = at(0), x1 = at(1), x2 = at(2), x3 = at(3);
    const auto w = numbers_at<V>(c + j, s + j);
    turn(x0, x1, w), turn(x2, x3, w);
    turn(x0, x2, numbers_at<V>(next_c + j, next_s + j));
    turn(x1, x3, numbers_at<V>(next_c + half + j, next_s + half + j));
    put(0, x0), put(1, x1), put(2, x2), put(3, x3);
  }
}

}  // namespace

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
  const bool narrow = half < kWide<T>, last = 2 * half == size_;
  for (int start = 0; start < size_; start += last ? 2 * half : 4 * half) {
    T *r = re + start, *i = im + start;
    if (last)
      narrow ? butterflies<T, 1>(r, i, half, c, s) : butterflies<Wide<T>, kWide<T>>(r, i, half, c, s);
    else
      narrow ? double_butterflies<T, 1>(r, i, half, c, s)
             : double_butterflies<Wide<T>, kWide<T>>(r, i, half, c, s);
  }
}

template <class T>
void Fft<T>::forward(T* re, T* im) const noexcept {
  for (int number = 0; number < stages_; ++number) stage(number, re, im);
}

template class Fft<float>;
template class Fft<double>;

}  // namespace rigsound::dsp
