// The inner loop, for the lane width RIGSOUND_LANES. Included by one source file per width; everything has
// internal linkage, because the linker must not merge code compiled for different processors.
//
// Skew: lane m works on the sample that entered the cascade m samples ago, so all sections of a vector can
// advance at once. The cascade's extra delay of (sections - 1) samples is taken out of the delay line.
#pragma once

#include <cstring>
#include <utility>

#include "tool/bar_kernel.hpp"

namespace rigsound::tool {
namespace {

constexpr int W = RIGSOUND_LANES;
using V __attribute__((vector_size(W * sizeof(double)))) = double;
using Bits __attribute__((vector_size(W * sizeof(double)))) = std::uint64_t;
using V2 __attribute__((vector_size(16))) = double;

template <class Vector, class T>
Vector load(const T* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector>
void store(double* to, Vector v) {
  std::memcpy(to, &v, sizeof v);
}

/// What lies as vectors do can be part of the instruction that uses it. For inner loops: gcc takes detours to
/// fill an array this way.
template <class Vector>
Vector load_aligned(const double* from) {
  using InMemory __attribute__((may_alias)) = Vector;
  return *reinterpret_cast<const InMemory*>(from);
}

template <class Vector>
void store_aligned(double* to, Vector v) {
  using InMemory __attribute__((may_alias)) = Vector;
  *reinterpret_cast<InMemory*>(to) = v;
}

/// Lanes move up by one; the lowest is left idle.
inline V shifted(V v) {
#if RIGSOUND_LANES == 4
  // Masked, as gcc takes three steps to move a zero in.
  return (V)((Bits)__builtin_shufflevector(v, v, 0, 0, 1, 2) & Bits{0, ~0ULL, ~0ULL, ~0ULL});
#else
  return __builtin_shufflevector(v, V{}, 3, 0);
#endif
}

/// Lanes move up by one; `sample` enters the lowest.
inline V pushed(V v, double sample) {
#if RIGSOUND_LANES == 4
  const V up = __builtin_shufflevector(v, v, 0, 0, 1, 2);
  return __builtin_shufflevector(up, V{sample}, 4, 1, 2, 3);
#else
  return V{sample, v[0]};
#endif
}

/// The same where lane 0 is another family's: `samples` enter it and the lowest of the others.
inline V pushed_apart(V v, V2 samples) {
#if RIGSOUND_LANES == 4
  const V up = __builtin_shufflevector(v, v, 0, 0, 1, 2);
  return __builtin_shufflevector(V{samples[0], samples[1]}, up, 0, 1, 6, 7);
#else
  (void)v;
  return samples;
#endif
}

inline V everywhere(double x) {
#if RIGSOUND_LANES == 4
  return V{x, x, x, x};
#else
  return V{x, x};
#endif
}

/// `sample` in the lane `entry` marks. Idle lanes are zero, so OR is as good as a choice.
inline V entered(V v, V sample, Bits entry) { return (V)((Bits)v | ((Bits)sample & entry)); }

/// Rest of both loops (DC blocker, shelf, reflection, delay line), then high-pass and mix. All in locals, as
/// the compiler must assume that a stored sample changes whatever is in memory.
struct Glue {
  explicit Glue(const BarState& s, const BarDrive& drive)
      : dc_r(load<V2>(s.dc_r)),
        sh_0(load<V2>(s.sh_0)),
        sh_1(load<V2>(s.sh_1)),
        sh_q(load<V2>(s.sh_q)),
        hp_b(V2{s.hp_b, s.hp_b}),
        hp_p(V2{s.hp_p, s.hp_p}),
        dc_s(load<V2>(s.dc_s)),
        sh_s(load<V2>(s.sh_s)),
        hp_r(load<V2>(s.hp_r)),
        x(drive.x),
        k_T(drive.k[kTransversal]),
        k_L(drive.k[kLongitudinal]),
        mix_T(drive.mix[kTransversal]),
        mix_L(drive.mix[kLongitudinal]) {}

  /// Closes both loops for sample `i`; v: what comes out of the cascades; line: where y goes.
  double close(int i, V2 v, double (*line)[2]) {
    const V2 b = v + dc_s;
    dc_s = dc_r * b - v;
    const V2 w = sh_0 * b + sh_s;
    sh_s = sh_1 * b + sh_q * w;
    const V2 y = V2{x[i], x[i]} + V2{k_T[i], k_L[i]} * w;
    hp_r = hp_b * (y - load_aligned<V2>(line[-1])) + hp_p * hp_r;
    store_aligned(line[0], y);
    const V2 weighed = V2{mix_T[i], mix_L[i]} * hp_r;
    return weighed[0] + weighed[1];
  }

  void keep(BarState& s, int frames) const {
    store(s.dc_s, dc_s);
    store(s.sh_s, sh_s);
    store(s.hp_r, hp_r);
    s.at += frames;
  }

  V2 dc_r, sh_0, sh_1, sh_q, hp_b, hp_p;
  V2 dc_s, sh_s, hp_r;
  const double *x, *k_T, *k_L, *mix_T, *mix_L;
};

/// The line as one sample of the chunk sees it.
struct Taps {
  explicit Taps(BarState& s)
      : now(s.line + s.at), T(now - s.delay[kTransversal]), L(now - s.delay[kLongitudinal]) {}

  void advance() { ++now, ++T, ++L; }

  double (*now)[2];         ///< where the new sample goes
  double (*T)[2], (*L)[2];  ///< what enters the cascades
};

/// NT vectors of transversal sections, then NL of longitudinal ones; with NL = 0 these sit in lane 0 of the
/// same vectors.
template <int NT, int NL>
void run_sections(BarState& state, const BarDrive& drive, double* out) noexcept {
  constexpr int N = NT + NL;
  SectionLanes& lanes = state.sections;
  V g0[N], g1[N], g2[N], c0[N], h[N], x1[N], x2[N], y[N];
  for (int j = 0; j < N; ++j) {
    g0[j] = load<V>(&lanes.g0[W * j]), g1[j] = load<V>(&lanes.g1[W * j]), g2[j] = load<V>(&lanes.g2[W * j]);
    c0[j] = load<V>(&lanes.c0[W * j]), h[j] = load<V>(&lanes.h[W * j]);
    x1[j] = load<V>(&lanes.x1[W * j]), x2[j] = load<V>(&lanes.x2[W * j]), y[j] = load<V>(&lanes.y[W * j]);
  }
  Glue glue(state, drive);
  Taps taps(state);
  const int frames = drive.frames;
  for (int i = 0; i < frames; ++i, taps.advance()) {
    const V2 from = {(*taps.L)[kLongitudinal], (*taps.T)[kTransversal]};
    V before = NL == 0 ? pushed_apart(y[NT - 1], from) : pushed(y[NT - 1], from[1]);
#pragma GCC unroll 24
    for (int j = 0; j < N; ++j) {
      const V u = j == NT ? pushed(y[N - 1], from[0]) : before;
      before = y[j];
      const V w = g0[j] * x1[j] - g1[j] * x2[j], m = w + g2[j] * u;
      y[j] = c0[j] * u - h[j] * w;
      x1[j] = m - x1[j];
      x2[j] = x2[j] + m;
    }
    out[i] = glue.close(i, V2{y[NT - 1][W - 1], y[N - 1][NL == 0 ? 0 : W - 1]}, taps.now);
  }
  glue.keep(state, frames);
  for (int j = 0; j < N; ++j) {
    store(&lanes.x1[W * j], x1[j]);
    store(&lanes.x2[W * j], x2[j]);
    store(&lanes.y[W * j], y[j]);
  }
}

/// The paper's sections in N vectors, too many for registers: between samples they live in memory.
template <int N>
struct PaperCascade {
  static constexpr int kEntries = N < W ? N : W;

  explicit PaperCascade(BarState& s)
      : lambda(everywhere(s.paper.lambda)), y_2(s.paper.y[s.paper.turn]), y_1(s.paper.y[1 - s.paper.turn]) {
    for (int j = 0; j < kEntries; ++j) entry[j] = load<Bits>(s.paper.entry[j]);
  }

  V section(V u, V mine_1, V u_1) const { return lambda * (u - mine_1) + u_1; }

  /// One sample: `line` is where it enters. Returns what leaves.
  double next(const double (*line)[2]) {
    const V from = everywhere(line[0][kTransversal]), from_1 = everywhere(line[-1][kTransversal]);
    V u = shifted(load_aligned<V>(&y_1[W * (N - 1)])), y{};
    const V around = shifted(load_aligned<V>(&y_2[W * (N - 1)]));
#pragma GCC unroll 32
    for (int j = 0; j < N; ++j) {
      V u_1 = j == 0 ? around : load_aligned<V>(&y_2[W * (j - 1)]);
      if (j < kEntries) u = entered(u, from, entry[j]), u_1 = entered(u_1, from_1, entry[j]);
      const V mine_1 = load_aligned<V>(&y_1[W * j]), before = y;
      y = section(u, mine_1, u_1);
      if (j > 0)
        store_aligned(&y_2[W * (j - 1)], before);  // not before it was read: so that is part of an addition
      u = mine_1;
    }
    store_aligned(&y_2[W * (N - 1)], y);
    double* const newest = y_2;
    y_2 = y_1;
    y_1 = newest;
    return y[W - 1];
  }

  /// Two samples at once: half the loads, and no store to wait for between them. Both have to be in the line.
  /// With two lanes there are too many vectors for that to help.
  V2 next_two(const double (*line)[2]) {
    constexpr int kLast = W * (N - 1);
    const V from_0 = everywhere(line[-1][kTransversal]), from_1 = everywhere(line[0][kTransversal]),
            from_2 = everywhere(line[1][kTransversal]);
    // Into the first vector the second sample comes from the last one's first.
    const V last = section(load<V>(&y_1[kLast - W]), load<V>(&y_1[kLast]), load<V>(&y_2[kLast - W]));
    V u_0 = shifted(load<V>(&y_2[kLast])), u_1 = shifted(load<V>(&y_1[kLast])), u_2 = shifted(last);
    V first{}, second{};
#pragma GCC unroll 32
    for (int j = 0; j < N; ++j) {
      if (j < kEntries) {
        u_0 = entered(u_0, from_0, entry[j]), u_1 = entered(u_1, from_1, entry[j]);
        u_2 = entered(u_2, from_2, entry[j]);
      }
      const V mine_1 = load<V>(&y_1[W * j]), mine_2 = load<V>(&y_2[W * j]);
      first = j == N - 1 ? last : section(u_1, mine_1, u_0);
      second = section(u_2, first, u_1);
      store(&y_2[W * j], first);
      store(&y_1[W * j], second);
      u_0 = mine_2, u_1 = mine_1, u_2 = first;
    }
    return V2{first[W - 1], second[W - 1]};
  }

  V lambda;
  Bits entry[kEntries];
  double *y_2, *y_1;  ///< outputs of the sample before last, and of the last
};

template <int N>
void run_paper(BarState& state, const BarDrive& drive, double* out) noexcept {
  PaperCascade<N> cascade(state);
  Glue glue(state, drive);
  Taps taps(state);
  const auto close = [&](int i, double v) {
    out[i] = glue.close(i, V2{v, (*taps.L)[kLongitudinal]}, taps.now);
    taps.advance();
  };
  int i = 0;
  if constexpr (W == 4 && N > W)
    if (state.delay[kTransversal] >= 2)
      for (; i + 1 < drive.frames; i += 2) {
        const V2 two = cascade.next_two(taps.T);
        close(i, two[0]);
        close(i + 1, two[1]);
      }
  for (; i < drive.frames; ++i) close(i, cascade.next(taps.T));
  state.paper.turn = cascade.y_2 == state.paper.y[0] ? 0 : 1;
  glue.keep(state, drive.frames);
}

template <int... N>
BarKernel paper_with(int vectors, std::integer_sequence<int, N...>) {
  static constexpr BarKernel kTable[] = {run_paper<N + 1>...};
  return kTable[vectors - 1];
}

template <int NL, int... NT>
BarKernel sections_with(int vectors_T, std::integer_sequence<int, NT...>) {
  static constexpr BarKernel kTable[] = {run_sections<NT + 1, NL>...};
  return kTable[vectors_T - 1];
}

using PaperCounts = std::make_integer_sequence<int, kPaperLanes / W>;
using SectionCounts = std::make_integer_sequence<int, kMaxSections / W>;
using SharedCounts = std::make_integer_sequence<int, W>;  ///< where BarLoops::seat lets them share

}  // namespace
}  // namespace rigsound::tool
