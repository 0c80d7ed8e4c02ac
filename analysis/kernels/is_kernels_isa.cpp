// Built several times with RIGSOUND_ISA naming the instruction set the compiler may use. Must not include
// anything with inline functions: their copies would be merged across instruction sets by the linker.
#include "kernels/is_kernels.hpp"

#include <math.h>

namespace rigsound::analysis {
namespace {

using Lanes = float __attribute__((vector_size(sizeof(float) * kLanes)));

inline Lanes load(const float* p) {
  Lanes x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

inline void store(float* p, const Lanes& x) { __builtin_memcpy(p, &x, sizeof x); }

inline float sum(const Lanes& x) {
  float total = 0;
  for (int i = 0; i < kLanes; ++i) total += x[i];
  return total;
}

template <int K>
inline Lanes inverse_model(const Activations& H, const float* w, int n) {
  Lanes L = w[0] * load(H.H + n);
  for (int k = 1; k < K; ++k) L += w[k] * load(H.H + k * H.frames + n);
  // The padding has no model and no power; the floor keeps its 0 / 0 away.
  const Lanes floor = Lanes{} + 1e-12f;
  L = L > floor ? L : floor;
  return 1.0f / L;
}

template <int K>
void fit_bin(const float* P, const Activations& H, float* w, int iterations, float exponent, float floor) {
  for (int i = 0; i < iterations; ++i) {
    Lanes numerator[K] = {}, denominator[K] = {};
    for (int n = 0; n < H.frames; n += kLanes) {
      const Lanes I = inverse_model<K>(H, w, n), R = load(P + n) * I * I;
      for (int k = 0; k < K; ++k) {
        const Lanes h = load(H.H + k * H.frames + n);
        numerator[k] += h * R;
        denominator[k] += h * I;
      }
    }
    for (int k = 0; k < K; ++k) {
      const float cost = H.cost ? H.cost[k] : 1.0f;
      const float ratio = sum(numerator[k]) / (cost * sum(denominator[k]) + 1e-12f);
      const float next = w[k] * (exponent == 1.0f ? ratio : powf(ratio, exponent));
      w[k] = next > floor ? next : floor;
    }
  }
}

template <int K>
void add_activation_terms(const float* P, const Activations& H, const float* w, int updated, float* numerator,
                          float* denominator) {
  for (int n = 0; n < H.frames; n += kLanes) {
    const Lanes I = inverse_model<K>(H, w, n), R = load(P + n) * I * I;
    for (int k = 0; k < updated; ++k) {
      const int at = k * H.frames + n;
      store(numerator + at, load(numerator + at) + w[k] * R);
      store(denominator + at, load(denominator + at) + w[k] * I);
    }
  }
}

template <int K>
struct Table {
  static void fit(const float* P, const Activations& H, float* w, int iterations, float exponent,
                  float floor) {
    if (H.words == K) return fit_bin<K>(P, H, w, iterations, exponent, floor);
    Table<K - 1>::fit(P, H, w, iterations, exponent, floor);
  }
  static void add(const float* P, const Activations& H, const float* w, int updated, float* numerator,
                  float* denominator) {
    if (H.words == K) return add_activation_terms<K>(P, H, w, updated, numerator, denominator);
    Table<K - 1>::add(P, H, w, updated, numerator, denominator);
  }
};

template <>
struct Table<0> {
  static void fit(const float*, const Activations&, float*, int, float, float) {}
  static void add(const float*, const Activations&, const float*, int, float*, float*) {}
};

void model_bin(const Activations& H, const float* w, int words, float* model) {
  for (int n = 0; n < H.frames; n += kLanes) {
    Lanes sum_of_words = {};
    for (int k = 0; k < words; ++k) sum_of_words += w[k] * load(H.H + k * H.frames + n);
    store(model + n, sum_of_words);
  }
}

}  // namespace

#define RIGSOUND_QUOTE(x) #x
#define RIGSOUND_NAME(x) RIGSOUND_QUOTE(x)
#define RIGSOUND_JOIN(a, b) a##b
#define RIGSOUND_KERNELS(isa) RIGSOUND_JOIN(kIsKernels_, isa)

extern const IsKernels RIGSOUND_KERNELS(RIGSOUND_ISA);
const IsKernels RIGSOUND_KERNELS(RIGSOUND_ISA) = {RIGSOUND_NAME(RIGSOUND_ISA), Table<kMaxWords>::fit,
                                                  Table<kMaxWords>::add, model_bin};

}  // namespace rigsound::analysis
