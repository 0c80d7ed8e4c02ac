// Vector arithmetic with a written order of additions: two doubles or four floats side by side, on every
// machine.
#pragma once

#include <cstdint>
#include <cstring>

namespace rigsound::dsp {

using Lanes = double __attribute__((vector_size(16)));

inline Lanes load(const double* p) noexcept {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Two floats, exactly.
inline Lanes load(const float* p) noexcept {
  using Floats = float __attribute__((vector_size(16)));
  using Doubles = double __attribute__((vector_size(32)));
  // gcc converts a vector of two floats one by one, one of four as two pairs, of which one is left out.
  const Doubles x = __builtin_convertvector((Floats{p[0], p[1], p[0], p[1]}), Doubles);
  return __builtin_shufflevector(x, x, 0, 1);
}

inline Lanes larger(Lanes a, Lanes b) noexcept { return a < b ? b : a; }

/// |x|
inline Lanes magnitude(Lanes x) noexcept {
  using Bits = std::int64_t __attribute__((vector_size(16)));
  Bits bits;
  std::memcpy(&bits, &x, sizeof x);
  bits &= std::int64_t{0x7fffffffffffffff};
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Lane 0 + lane 1; a number is its own. Thread: RT.
inline double total(Lanes x) noexcept { return x[0] + x[1]; }
inline double total(double x) noexcept { return x; }

inline void store(double* p, Lanes v) noexcept { std::memcpy(p, &v, sizeof v); }

/// Both rounded to a float.
inline void store(float* p, Lanes v) noexcept {
  using Floats = float __attribute__((vector_size(8)));
  const Floats rounded = __builtin_convertvector(v, Floats);
  std::memcpy(p, &rounded, sizeof rounded);
}

/// sum a[i] b[i] for n a multiple of 8: four accumulators of two lanes, added as
/// ((s0 + s1) + (s2 + s3)), then lane 0 + lane 1. Thread: RT.
inline double dot(const double* a, const double* b, int n) noexcept {
  Lanes s0{}, s1{}, s2{}, s3{};
  for (int i = 0; i < n; i += 8) {
    s0 += load(a + i) * load(b + i);
    s1 += load(a + i + 2) * load(b + i + 2);
    s2 += load(a + i + 4) * load(b + i + 4);
    s3 += load(a + i + 6) * load(b + i + 6);
  }
  const Lanes s = (s0 + s1) + (s2 + s3);
  return s[0] + s[1];
}

using FloatLanes = float __attribute__((vector_size(16)));

inline FloatLanes load_floats(const float* p) noexcept {
  FloatLanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

inline void store_floats(float* p, FloatLanes v) noexcept { std::memcpy(p, &v, sizeof v); }

/// Lanes (0 + 2) + (1 + 3). Thread: RT.
inline float total(FloatLanes x) noexcept {
  const FloatLanes pairs = x + __builtin_shufflevector(x, x, 2, 3, 0, 1);
  return pairs[0] + pairs[1];
}

/// total() of each, side by side. Thread: RT.
inline FloatLanes totals(FloatLanes a, FloatLanes b, FloatLanes c, FloatLanes d) noexcept {
  const FloatLanes ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const FloatLanes cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// As dot() of doubles, in two accumulators of four lanes. Thread: RT.
inline float dot(const float* a, const float* b, int n) noexcept {
  FloatLanes s0{}, s1{};
  for (int i = 0; i < n; i += 8) {
    s0 += load_floats(a + i) * load_floats(b + i);
    s1 += load_floats(a + i + 4) * load_floats(b + i + 4);
  }
  return total(s0 + s1);
}

}  // namespace rigsound::dsp
