// Built several times with RIGSOUND_ISA naming the instruction set the compiler may use. Must not include
// anything with inline functions: their copies would be merged across instruction sets by the linker.
#include "kernels/click_kernels.hpp"

#include <math.h>

#include "kernels/isa_names.hpp"

namespace rigsound::analysis {
namespace {

// Eight partial sums, in as many parts as their registers: what is wider than a register lies in memory.
#if defined(__AVX512F__)
constexpr int kRegister = 64;
#elif defined(__AVX__)
constexpr int kRegister = 32;
#else
constexpr int kRegister = 16;
#endif
constexpr int kPartials = 8, kPart = kRegister / sizeof(double), kParts = kPartials / kPart;
constexpr int kBoth = 2 * kPartials;  // two values are inverted by one division
using Part = double __attribute__((vector_size(kRegister)));
using PartBits = unsigned long long __attribute__((vector_size(kRegister)));
constexpr int kTaps = kRegister / sizeof(float);  // samples side by side
using Samples = float __attribute__((vector_size(kRegister)));

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

inline double sum(const Part (&x)[kParts]) {
  double total = 0;
  for (const Part& part : x)
    for (int i = 0; i < kPart; ++i) total += part[i];
  return total;
}

inline Part at_most(double most, const Part& x) {
  const Part limit = Part{} + most;
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
  for (; n + kPart <= size; n += kPart) store(v + n, floor + carried * load<Part>(decay + n));
  for (; n < size; ++n) v[n] = floor + carried * decay[n];
}

struct Reciprocals {
  Part first, second;
};

/// By one division for both: the loops wait for little else.
inline Reciprocals reciprocals(const Part& a, const Part& b) {
  const Part of_both = 1.0 / (a * b);
  return {of_both * b, of_both * a};
}

/// So many of the values from p on, then `rest`.
inline void load_some(const double* p, long count, double rest, double (&to)[kBoth]) {
  for (int i = 0; i < kBoth; ++i) to[i] = i < count ? p[i] : rest;
}

struct PartialSums {
  Part x[kParts] = {}, y[kParts] = {}, ax[kParts] = {}, ay[kParts] = {};

  inline void add(int part, const Part& q, const Part& inverse, const Part& a, double clip) {
    const Part slope = at_most(clip, q * inverse) * inverse;
    x[part] += slope, y[part] += inverse, ax[part] += a * slope, ay[part] += a * inverse;
  }
};

WeighedSums weigh(const double* q, const double* v, const double* a, double clip, long size) {
  PartialSums sums;
  long n = 0;
  for (; n + kBoth <= size; n += kBoth)
    for (int part = 0; part < kParts; ++part) {
      const long one = n + part * kPart, other = one + kPartials;
      const Reciprocals i = reciprocals(load<Part>(v + one), load<Part>(v + other));
      sums.add(part, load<Part>(q + one), i.first, load<Part>(a + one), clip);
      sums.add(part, load<Part>(q + other), i.second, load<Part>(a + other), clip);
    }
  if (const long left = size - n; left > 0) {
    constexpr double kPlace[kBoth] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    double some_q[kBoth], some_v[kBoth], some_a[kBoth];
    load_some(q + n, left, 0, some_q), load_some(v + n, left, 1, some_v), load_some(a + n, left, 0, some_a);
    const Part end = Part{} + static_cast<double>(left);
    for (int part = 0; part < kParts; ++part) {
      const int one = part * kPart, other = one + kPartials;
      const Reciprocals i = reciprocals(load<Part>(some_v + one), load<Part>(some_v + other));
      const Part first = load<Part>(kPlace + one) < end ? i.first : Part{};
      const Part second = load<Part>(kPlace + other) < end ? i.second : Part{};
      sums.add(part, load<Part>(some_q + one), first, load<Part>(some_a + one), clip);
      sums.add(part, load<Part>(some_q + other), second, load<Part>(some_a + other), clip);
    }
  }
  return {sum(sums.x), sum(sums.y), sum(sums.ax), sum(sums.ay)};
}

PairOfSums products(const double* a, const double* x, const double* y, long size) {
  Part first[kParts] = {}, second[kParts] = {};
  long n = 0;
  for (; n + kPartials <= size; n += kPartials)
    for (int part = 0; part < kParts; ++part) {
      const long at = n + part * kPart;
      const Part factor = load<Part>(a + at);
      first[part] += factor * load<Part>(x + at), second[part] += factor * load<Part>(y + at);
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
  Part mantissas[kParts], quotients[kParts] = {};
  PartBits exponents[kParts] = {};
  for (Part& part : mantissas) part = Part{} + 1.0;
  long n = 0;
  while (n + kBoth <= size) {
    for (long k = 0; k < kMostFactors && n + kBoth <= size; k += 2, n += kBoth)
      for (int part = 0; part < kParts; ++part) {
        const long one = n + part * kPart, other = one + kPartials;
        const Part x = load<Part>(v + one), y = load<Part>(v + other);
        const Reciprocals i = reciprocals(x, y);
        mantissas[part] *= mantissa(x, exponents[part]) * mantissa(y, exponents[part]);
        quotients[part] += at_most(clip, load<Part>(q + one) * i.first);
        quotients[part] += at_most(clip, load<Part>(q + other) * i.second);
      }
    for (int part = 0; part < kParts; ++part) mantissas[part] = mantissa(mantissas[part], exponents[part]);
  }
  double product = 1, quotient = sum(quotients);
  unsigned long long exponent = 0;
  for (int part = 0; part < kParts; ++part)
    for (int i = 0; i < kPart; ++i) product *= mantissas[part][i], exponent += exponents[part][i];
  for (; n < size; ++n) product *= mantissa(v[n], exponent), quotient += at_most(clip, q[n] / v[n]);
  return {log(product) + kLn2 * static_cast<double>(static_cast<long long>(exponent)), quotient};
}

}  // namespace

extern const ClickKernels RIGSOUND_OF_ISA(kClickKernels_);
const ClickKernels RIGSOUND_OF_ISA(kClickKernels_) = {RIGSOUND_ISA_NAME, filter,    tail, weigh,
                                                      products,          divergence};

}  // namespace rigsound::analysis
