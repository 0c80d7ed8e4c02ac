// The pairings of a stage at any width. Included by one source file per width; what does not depend on the
// width has internal linkage, because the linker must not merge code compiled for different processors.
#pragma once

#include "fft_pairings.hpp"
#include "vector_memory.hpp"

namespace rigsound::dsp {
namespace {

template <class T, int kBytes>
struct VectorOf {
  using V __attribute__((vector_size(kBytes))) = T;
};

template <class V, class T>
constexpr int kSideBySide = sizeof(V) / sizeof(T);

/// As many complex numbers side by side as a V holds.
template <class V>
struct ComplexValues {
  V re, im;
};

template <class V, class T>
ComplexValues<V> numbers_at(const T* re, const T* im) noexcept {
  return {vector_at<V>(re), vector_at<V>(im)};
}

template <class V, class T>
void put_numbers_at(T* re, T* im, const ComplexValues<V>& x) noexcept {
  put(re, x.re), put(im, x.im);
}

/// a and b become a + w b and a - w b.
template <class V>
void turn(ComplexValues<V>& a, ComplexValues<V>& b, const ComplexValues<V>& w) noexcept {
  const V re = b.re * w.re - b.im * w.im, im = b.re * w.im + b.im * w.re;
  b = {a.re - re, a.im - im};
  a = {a.re + re, a.im + im};
}

/// Of one pair of halves.
template <class V, class T>
void butterflies(T* re, T* im, int half, const T* c, const T* s) noexcept {
  for (int j = 0; j < half; j += kSideBySide<V, T>) {
    auto x0 = numbers_at<V>(re + j, im + j), x1 = numbers_at<V>(re + half + j, im + half + j);
    turn(x0, x1, numbers_at<V>(c + j, s + j));
    put_numbers_at(re + half + j, im + half + j, x1), put_numbers_at(re + j, im + j, x0);
  }
}

/// Of two pairs, then of their own pair: half the loads and stores of one after the other.
template <class V, class T>
void double_butterflies(T* re, T* im, int half, const T* c, const T* s) noexcept {
  const T *next_c = c + half, *next_s = s + half;
  for (int j = 0; j < half; j += kSideBySide<V, T>) {
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

template <class V, class T>
void pair(const FftStage<T>& stage, T* re, T* im) noexcept {
  const int half = stage.half, step = stage.last ? 2 * half : 4 * half;
  for (int start = 0; start < stage.size; start += step)
    if (stage.last)
      butterflies<V>(re + start, im + start, half, stage.cos, stage.sin);
    else
      double_butterflies<V>(re + start, im + start, half, stage.cos, stage.sin);
}

template <LaneWidth kWidth, class T>
void pair_widest(const FftStage<T>& stage, T* re, T* im) noexcept {
  constexpr int kNarrow = 16, kWide = static_cast<int>(kWidth) * static_cast<int>(sizeof(double));
  using Narrow = typename VectorOf<T, kNarrow>::V;
  using Wide = typename VectorOf<T, kWide>::V;
  if (stage.half >= kSideBySide<Wide, T>) return pair<Wide>(stage, re, im);
  if (stage.half >= kSideBySide<Narrow, T>) return pair<Narrow>(stage, re, im);
  pair<T>(stage, re, im);
}

}  // namespace

template <LaneWidth kWidth>
void FftPairings<kWidth>::run(const FftStage<float>& stage, float* re, float* im) noexcept {
  pair_widest<kWidth>(stage, re, im);
}

template <LaneWidth kWidth>
void FftPairings<kWidth>::run(const FftStage<double>& stage, double* re, double* im) noexcept {
  pair_widest<kWidth>(stage, re, im);
}

}  // namespace rigsound::dsp
