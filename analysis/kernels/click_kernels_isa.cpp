// Built several times with RIGSOUND_ISA naming the instruction set the compiler may use. Must not include
// anything with inline functions: their copies would be merged across instruction sets by the linker.
#include "kernels/click_kernels.hpp"

#include <math.h>

#include "kernels/isa_names.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kWide = 8;
using Wide = double __attribute__((vector_size(sizeof(double) * kWide)));
using WideBits = unsigned long long __attribute__((vector_size(sizeof(double) * kWide)));
constexpr int kTaps = 16;  // floats side by side
using Samples = float __attribute__((vector_size(sizeof(float) * kTaps)));

constexpr unsigned long long kMantissa = 0xFFFFFFFFFFFFF, kOne = 0x3FF0000000000000;
constexpr int kMantissaBits = 52, kExponentOfOne = 1023;
constexpr long kMostFactors = 512;  // of 1 ... 2 within a double
constexpr double kLn2 = 0.69314718055994531;

template <class V, class T>
inline V load(const T* p) {
  V x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

template <class V, class T>
inline void store(T* p, const V& x) {
  __builtin_memcpy(p, &x, sizeof x);
}

inline double sum(const Wide& x) {
  double total = 0;
  for (int i = 0; i < kWide; ++i) total += x[i];
  return total;
}

inline Wide at_most(double most, const Wide& x) {
  const Wide limit = Wide{} + most;
  return x < limit ? x : limit;
}

inline double at_most(double most, double x) { return x < most ? x : most; }

void filter(const float* x, long size, const float* A, int taps, float* y) {
  constexpr int kSideBySide = 8;
  long n = 0;
  for (; n + kSideBySide * kTaps <= size; n += kSideBySide * kTaps) {
    Samples sums[kSideBySide] = {};
    for (int k = 0; k < taps; ++k)
      for (int j = 0; j < kSideBySide; ++j) sums[j] += A[k] * load<Samples>(x + n + j * kTaps - k);
    for (int j = 0; j < kSideBySide; ++j) store(y + n + j * kTaps, sums[j]);
  }
  for (; n < size; ++n) {
    float total = 0;
    for (int k = 0; k < taps; ++k) total += A[k] * x[n - k];
    y[n] = total;
  }
}

void tail(double carried, const double* decay, double floor, long size, double* v) {
  long n = 0;
  for (; n + kWide <= size; n += kWide) store(v + n, floor + carried * load<Wide>(decay + n));
  for (; n < size; ++n) v[n] = floor + carried * decay[n];
}

struct Reciprocals {
  Wide first, second;
};

/// By one division for both: the loops wait for little else.
inline Reciprocals reciprocals(const Wide& a, const Wide& b) {
  const Wide of_both = 1.0 / (a * b);
  return {of_both * b, of_both * a};
}

/// So many of the values from p on, then `rest`.
template <int Size>
inline void load_some(const double* p, long count, double rest, double (&to)[Size]) {
  for (int i = 0; i < Size; ++i) to[i] = i < count ? p[i] : rest;
}

inline Wide first_lanes(long count, const Wide& x) {
  constexpr Wide kLane = {0, 1, 2, 3, 4, 5, 6, 7};
  const Wide limit = Wide{} + static_cast<double>(count);
  return kLane < limit ? x : Wide{};
}

struct WideSums {
  Wide x = {}, y = {}, ax = {}, ay = {};

  inline void add(const Wide& q, const Wide& inverse, const Wide& a, double clip) {
    const Wide slope = at_most(clip, q * inverse) * inverse;
    x += slope, y += inverse, ax += a * slope, ay += a * inverse;
  }
};

WeighedSums weigh(const double* q, const double* v, const double* a, double clip, long size) {
  WideSums sums;
  long n = 0;
  for (; n + 2 * kWide <= size; n += 2 * kWide) {
    const Reciprocals i = reciprocals(load<Wide>(v + n), load<Wide>(v + n + kWide));
    sums.add(load<Wide>(q + n), i.first, load<Wide>(a + n), clip);
    sums.add(load<Wide>(q + n + kWide), i.second, load<Wide>(a + n + kWide), clip);
  }
  if (const long left = size - n; left > 0) {
    double some_q[2 * kWide], some_v[2 * kWide], some_a[2 * kWide];
    load_some(q + n, left, 0, some_q), load_some(v + n, left, 1, some_v), load_some(a + n, left, 0, some_a);
    const Reciprocals i = reciprocals(load<Wide>(some_v), load<Wide>(some_v + kWide));
    sums.add(load<Wide>(some_q), first_lanes(left, i.first), load<Wide>(some_a), clip);
    sums.add(load<Wide>(some_q + kWide), first_lanes(left - kWide, i.second), load<Wide>(some_a + kWide),
             clip);
  }
  return {sum(sums.x), sum(sums.y), sum(sums.ax), sum(sums.ay)};
}

PairOfSums products(const double* a, const double* x, const double* y, long size) {
  Wide first = {}, second = {};
  long n = 0;
  for (; n + kWide <= size; n += kWide) {
    const Wide factor = load<Wide>(a + n);
    first += factor * load<Wide>(x + n), second += factor * load<Wide>(y + n);
  }
  PairOfSums sums{sum(first), sum(second)};
  for (; n < size; ++n) sums.first += a[n] * x[n], sums.second += a[n] * y[n];
  return sums;
}

/// Of positive, normal values; what their exponents say is added to `exponents`.
template <class V, class Bits>
inline V mantissa(const V& x, Bits& exponents) {
  const auto bits = load<Bits>(&x);
  exponents += (bits >> kMantissaBits) - kExponentOfOne;
  const Bits of_mantissa = (bits & kMantissa) | kOne;
  return load<V>(&of_mantissa);
}

/// Mantissas multiplied, exponents added: one logarithm for all.
PairOfSums divergence(const double* q, const double* v, double clip, long size) {
  Wide mantissas = Wide{} + 1.0, quotients = {};
  WideBits exponents = {};
  long n = 0;
  while (n + 2 * kWide <= size) {
    for (long k = 0; k < kMostFactors && n + 2 * kWide <= size; k += 2, n += 2 * kWide) {
      const Wide x = load<Wide>(v + n), y = load<Wide>(v + n + kWide);
      const Reciprocals i = reciprocals(x, y);
      mantissas *= mantissa(x, exponents) * mantissa(y, exponents);
      quotients += at_most(clip, load<Wide>(q + n) * i.first);
      quotients += at_most(clip, load<Wide>(q + n + kWide) * i.second);
    }
    mantissas = mantissa(mantissas, exponents);
  }
  double product = 1, quotient = sum(quotients);
  unsigned long long exponent = 0;
  for (int lane = 0; lane < kWide; ++lane) product *= mantissas[lane], exponent += exponents[lane];
  for (; n < size; ++n) product *= mantissa(v[n], exponent), quotient += at_most(clip, q[n] / v[n]);
  return {log(product) + kLn2 * static_cast<double>(static_cast<long long>(exponent)), quotient};
}

}  // namespace

extern const ClickKernels RIGSOUND_OF_ISA(kClickKernels_);
const ClickKernels RIGSOUND_OF_ISA(kClickKernels_) = {RIGSOUND_ISA_NAME, filter,    tail, weigh,
                                                      products,          divergence};

}  // namespace rigsound::analysis
