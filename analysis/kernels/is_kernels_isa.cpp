// Built several times with RIGSOUND_ISA naming the instruction set the compiler may use. Must not include
// anything with inline functions: their copies would be merged across instruction sets by the linker.
#include "kernels/is_kernels.hpp"

#include <math.h>

#include "kernels/isa_names.hpp"

namespace rigsound::analysis {
namespace {

// As many of kLanes at a time as a register holds: the sums of wider ones would lie in memory.
#if defined(__AVX512F__)
constexpr int kWidth = 16;
#elif defined(__AVX__)
constexpr int kWidth = 8;
#else
constexpr int kWidth = 4;
#endif
using Lanes = float __attribute__((vector_size(sizeof(float) * kWidth)));
using LaneBits = int __attribute__((vector_size(sizeof(int) * kWidth)));

constexpr int kRootHalf = 0x3F3504F3, kFloatMantissaBits = 23;  // 1/sqrt(2) as a float's bits
constexpr int kExponentBits = -(1 << kFloatMantissaBits);
constexpr float kNaturalLog2 = 0.693147181f;

inline Lanes load(const float* p) {
  Lanes x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

inline void store(float* p, const Lanes& x) { __builtin_memcpy(p, &x, sizeof x); }

template <int K>
inline Lanes inverse_model(const Lanes* h, const float* w) {
  Lanes L = w[0] * h[0];
  for (int k = 1; k < K; ++k) L += w[k] * h[k];
  // The padding has no model and no power; the floor keeps its 0 / 0 away.
  const Lanes floor = Lanes{} + 1e-12f;
  L = L > floor ? L : floor;
  return 1.0f / L;
}

inline Lanes between(float least, float most, Lanes x) {
  const Lanes low = Lanes{} + least, high = Lanes{} + most;
  x = x > low ? x : low;
  return x < high ? x : high;
}

/// ratio^exponent; large exponents start where words are far off.
inline Lanes update_factor(Lanes ratio, float exponent) {
  for (; exponent > 1; exponent /= 2) ratio = between(1 / kLargestStep, kLargestStep, ratio * ratio);
  if (exponent < 1)
    for (int lane = 0; lane < kWidth; ++lane) ratio[lane] = powf(ratio[lane], exponent);
  return ratio;
}

template <int K>
inline void update_words(const float* P, int frames, const Activations& H, float exponent, float floor,
                         Lanes* w) {
  Lanes numerator[K] = {}, denominator[K] = {};
  for (int n = 0; n < frames; ++n) {
    Lanes L = w[0] * H.H[n];
    for (int k = 1; k < K; ++k) L += w[k] * H.H[k * H.frames + n];
    const Lanes I = 1.0f / L, R = load(P + n * kLanes) * I * I;
    for (int k = 0; k < K; ++k) {
      numerator[k] += H.H[k * H.frames + n] * R;
      denominator[k] += H.H[k * H.frames + n] * I;
    }
  }
  const Lanes least = Lanes{} + floor;
  for (int k = 0; k < K; ++k) {
    const float cost = H.cost ? H.cost[k] : 1.0f;
    w[k] *= update_factor(numerator[k] / (cost * denominator[k] + 1e-12f), exponent);
    w[k] = w[k] > least ? w[k] : least;
  }
}

template <int K>
void fit_bins(const BinGroup& bins, const Activations& H, const Updates& updates, float floor) {
  for (int first = 0; first < bins.count; first += kWidth) {
    const int count = bins.count - first < kWidth ? bins.count - first : kWidth;
    Lanes w[K];
    for (int lane = 0; lane < kWidth; ++lane) {  // those beyond the last bin repeat it
      const float* row = bins.W + (first + (lane < count ? lane : count - 1)) * K;
      for (int k = 0; k < K; ++k) w[k][lane] = row[k];
    }
    for (int i = 0; i < updates.count; ++i)
      update_words<K>(bins.P + first, bins.frames, H, updates.exponents[i % updates.period], floor, w);
    for (int lane = 0; lane < count; ++lane)
      for (int k = 0; k < K; ++k) bins.W[(first + lane) * K + k] = w[k][lane];
  }
}

/// The sums of rows first ... first + Rows - 1 of H.
template <int K, int Rows>
inline void sum_rows(const PowerRows& power, const Activations& H, int first, float* numerator,
                     float* denominator) {
  for (int n = 0; n < H.frames; n += kWidth) {
    Lanes h[K], R_sum[Rows] = {}, I_sum[Rows] = {};
    for (int k = 0; k < K; ++k) h[k] = load(H.H + k * H.frames + n);
    for (int m = 0; m < power.bins; ++m) {
      const float* w = power.W + m * K;
      const Lanes I = inverse_model<K>(h, w), R = load(power.P + m * H.frames + n) * I * I;
      for (int k = 0; k < Rows; ++k) R_sum[k] += w[first + k] * R, I_sum[k] += w[first + k] * I;
    }
    for (int k = 0; k < Rows; ++k) {
      store(numerator + (first + k) * H.frames + n, R_sum[k]);
      store(denominator + (first + k) * H.frames + n, I_sum[k]);
    }
  }
}

template <int K>
void sum_over_bins(const PowerRows& power, const Activations& H, int updated, float* numerator,
                   float* denominator) {
  int k = 0;  // two rows at a time: their sums stay in registers
  for (; k + 2 <= updated; k += 2) sum_rows<K, 2>(power, H, k, numerator, denominator);
  if (k < updated) sum_rows<K, 1>(power, H, k, numerator, denominator);
}

template <int K>
struct Table {
  static void fit(const BinGroup& bins, const Activations& H, const Updates& updates, float floor) {
    if (H.words == K) return fit_bins<K>(bins, H, updates, floor);
    Table<K - 1>::fit(bins, H, updates, floor);
  }
  static void sum(const PowerRows& power, const Activations& H, int updated, float* numerator,
                  float* denominator) {
    if (H.words == K) return sum_over_bins<K>(power, H, updated, numerator, denominator);
    Table<K - 1>::sum(power, H, updated, numerator, denominator);
  }
};

template <>
struct Table<0> {
  static void fit(const BinGroup&, const Activations&, const Updates&, float) {}
  static void sum(const PowerRows&, const Activations&, int, float*, float*) {}
};

void model_bin(const Activations& H, const float* w, int words, float* model) {
  for (int n = 0; n < H.frames; n += kWidth) {
    Lanes sum_of_words = {};
    for (int k = 0; k < words; ++k) sum_of_words += w[k] * load(H.H + k * H.frames + n);
    store(model + n, sum_of_words);
  }
}

/// Of positive, normal values: of the mantissa, 1/sqrt(2) ... sqrt(2), by 2 artanh(s), s = (x - 1)/(x + 1),
/// whose series is left where a float ends.
inline Lanes logarithm(const Lanes& x) {
  LaneBits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const LaneBits octaves = (bits - kRootHalf) & kExponentBits;
  bits -= octaves;
  Lanes mantissa;
  __builtin_memcpy(&mantissa, &bits, sizeof mantissa);
  const Lanes s = (mantissa - 1.0f) / (mantissa + 1.0f), s2 = s * s;
  const Lanes series = 1.0f + s2 * (1 / 3.0f + s2 * (1 / 5.0f + s2 * (1 / 7.0f + s2 * (1 / 9.0f))));
  return __builtin_convertvector(octaves >> kFloatMantissaBits, Lanes) * kNaturalLog2 + 2.0f * s * series;
}

void divergence(const float* P, const float* L, int size, float* d) {
  for (int n = 0; n < size; n += kWidth) {
    const Lanes ratio = load(P + n) / load(L + n);
    store(d + n, ratio - logarithm(ratio) - 1.0f);
  }
}

}  // namespace

extern const IsKernels RIGSOUND_OF_ISA(kIsKernels_);
const IsKernels RIGSOUND_OF_ISA(kIsKernels_) = {RIGSOUND_ISA_NAME, Table<kMaxWords>::fit,
                                                Table<kMaxWords>::sum, divergence, model_bin};

}  // namespace rigsound::analysis
