// The passes at any width. Included by one source file per width; what does not depend on the width has
// internal linkage, because the linker must not merge code compiled for different processors.
#pragma once

#include <cstdint>
#include <cstring>

#include "rigsound/dsp/passes.hpp"
#include "vector_memory.hpp"

namespace rigsound::dsp {
namespace {

using Two __attribute__((vector_size(16))) = double;
using Four __attribute__((vector_size(32))) = double;
using TwoFloats __attribute__((vector_size(8))) = float;
using FourFloats __attribute__((vector_size(16))) = float;

template <LaneWidth>
struct Vector;
template <>
struct Vector<LaneWidth::kTwo> {
  using V = Two;
  using Floats = TwoFloats;
  using Bits __attribute__((vector_size(16))) = std::int64_t;
};
template <>
struct Vector<LaneWidth::kFour> {
  using V = Four;
  using Floats = FourFloats;
  using Bits __attribute__((vector_size(32))) = std::int64_t;
};

template <class V>
constexpr int kLanes = sizeof(V) / sizeof(double);

template <class V>
V larger_of(V a, V b) {
  return a < b ? b : a;
}

/// Both gains as often as there are frames in a V.
template <class V>
V repeated(Two x) {
  V v;
  for (int k = 0; k < kLanes<V> / 2; ++k)
    std::memcpy(reinterpret_cast<char*>(&v) + k * sizeof x, &x, sizeof x);
  return v;
}

/// As many frames as there are samples in a V.
template <class V>
struct Frames {
  V lower, upper;

  void put_to(Lanes* frames) const { put(frames, lower), put(frames + kLanes<V> / 2, upper); }
};

template <class V>
Frames<V> operator+(const Frames<V>& a, const Frames<V>& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}

template <class V>
Frames<V> frames_at(const Lanes* frames) {
  return {vector_at<V>(frames), vector_at<V>(frames + kLanes<V> / 2)};
}

template <class V>
class Placing {
 public:
  explicit Placing(const Placed& placed) : x_(placed.x), gains_(repeated<V>(placed.gains)) {}

  Frames<V> from(int n) const {
    const V x = vector_at<V>(x_ + n);
    if constexpr (kLanes<V> == 2)
      return {gains_ * __builtin_shufflevector(x, x, 0, 0), gains_ * __builtin_shufflevector(x, x, 1, 1)};
    else
      return {gains_ * __builtin_shufflevector(x, x, 0, 0, 1, 1),
              gains_ * __builtin_shufflevector(x, x, 2, 2, 3, 3)};
  }

 private:
  const double* x_;
  V gains_;
};

/// Of eight samples at a time, in as many vectors as hold them.
template <class V>
struct SquareSums {
  static constexpr int kParts = 8 / kLanes<V>;
  V sum[kParts] = {}, most[kParts] = {};

  void take(V x, int part) {
    const V square = x * x;
    sum[part] += square;
    most[part] = larger_of(most[part], square);
  }

  Squares joined() const {
    Two s[4], m[4];
    std::memcpy(s, sum, sizeof s), std::memcpy(m, most, sizeof m);
    return {(s[0] + s[1]) + (s[2] + s[3]), larger_of(larger_of(m[0], m[1]), larger_of(m[2], m[3]))};
  }
};

}  // namespace

template <LaneWidth kWidth>
void Passes<kWidth>::add_scaled(double gain, const float* x, int count, double* out) noexcept {
  using V = typename Vector<kWidth>::V;
  constexpr int W = kLanes<V>;
  int n = 0;
#pragma GCC unroll 2
  for (; n + 3 < count; n += 4) {
    // Written out, gcc converts four at once; a vector of them, in two halves.
    const Four wide = {static_cast<double>(x[n]), static_cast<double>(x[n + 1]),
                       static_cast<double>(x[n + 2]), static_cast<double>(x[n + 3])};
    V parts[4 / W];
    std::memcpy(parts, &wide, sizeof parts);
#pragma GCC unroll 2
    for (int p = 0; p < 4 / W; ++p) put(out + n + p * W, vector_at<V>(out + n + p * W) + gain * parts[p]);
  }
  for (; n < count; ++n) out[n] += gain * static_cast<double>(x[n]);
}

template <LaneWidth kWidth>
void Passes<kWidth>::place(const Placed& only, int count, Lanes* frames) noexcept {
  using V = typename Vector<kWidth>::V;
  const Placing<V> placing(only);
  for (int n = 0; n < count; n += kLanes<V>) placing.from(n).put_to(frames + n);
}

template <LaneWidth kWidth>
void Passes<kWidth>::place(const Placed& first, const Placed& second, int count, Lanes* frames) noexcept {
  using V = typename Vector<kWidth>::V;
  const Placing<V> one(first), other(second);
  for (int n = 0; n < count; n += kLanes<V>) (one.from(n) + other.from(n)).put_to(frames + n);
}

template <LaneWidth kWidth>
void Passes<kWidth>::add_placed(const Placed& more, int count, Lanes* frames) noexcept {
  using V = typename Vector<kWidth>::V;
  const Placing<V> placing(more);
  for (int n = 0; n < count; n += kLanes<V>) (frames_at<V>(frames + n) + placing.from(n)).put_to(frames + n);
}

template <LaneWidth kWidth>
Squares Passes<kWidth>::squares(const double* x, int count) noexcept {
  using V = typename Vector<kWidth>::V;
  SquareSums<V> sums;
  for (int n = 0; n < count; n += 8)
#pragma GCC unroll 4
    for (int part = 0; part < sums.kParts; ++part) sums.take(vector_at<V>(x + n + part * kLanes<V>), part);
  return sums.joined();
}

template <LaneWidth kWidth>
Squares Passes<kWidth>::narrow(const Lanes* frames, int count, float* out) noexcept {
  using V = typename Vector<kWidth>::V;
  SquareSums<V> sums;
  for (int n = 0; n < count; n += 4)
#pragma GCC unroll 4
    for (int part = 0; part < sums.kParts; ++part) {
      const V x = vector_at<V>(frames + n + part * kLanes<V> / 2);
      sums.take(x, part);
      put(out + 2 * n + part * kLanes<V>, __builtin_convertvector(x, typename Vector<kWidth>::Floats));
    }
  return sums.joined();
}

template <LaneWidth kWidth>
void Passes<kWidth>::highest_of_eights(const Lanes* frames, int count, double* highest) noexcept {
  using V = typename Vector<kWidth>::V;
  using Bits = typename Vector<kWidth>::Bits;
  constexpr int kFrames = kLanes<V> / 2;
  for (int n = 0; n < count; n += 8) {
    V most{};
#pragma GCC unroll 8
    for (int k = 0; k < 8; k += kFrames)
      most = larger_of(most, (V)((Bits)vector_at<V>(frames + n + k) & std::int64_t{0x7fffffffffffffff}));
    Two pair[kFrames];
    std::memcpy(pair, &most, sizeof pair);
    for (int k = 1; k < kFrames; ++k) pair[0] = larger_of(pair[0], pair[k]);
    *highest++ = pair[0][0] < pair[0][1] ? pair[0][1] : pair[0][0];
  }
}

}  // namespace rigsound::dsp
