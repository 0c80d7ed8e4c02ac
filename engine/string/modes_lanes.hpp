// The inner loop of the bending modes, for the lane width RIGSOUND_LANES.
#pragma once

#include "string/vector_lanes.hpp"

namespace rigsound::string {
namespace {

inline V kept(V v, Bits where) { return (V)((Bits)v & where); }

/// v held within 0...1.
inline V held(V v) {
  const Bits above = v >= everywhere(1);
  return kept(kept(v, v > V{}), ~above) + kept(everywhere(1), above);
}

/// U groups at a time: a part of each, its coefficients and state in registers.
template <int U>
struct Modes {
  Modes(const ModesState& s, int first) {
#pragma GCC unroll 5
    for (int u = 0; u < U; ++u) {
      const int k = first + kGroup * u;
      a1[u] = load(s.a1 + k), b2[u] = V{} - load(s.b2 + k), in[u] = load(s.in + k);
      y1[u] = load(s.y1 + k), y2[u] = load(s.y2 + k);
    }
  }

  void keep(ModesState& s, int first) const {
#pragma GCC unroll 5
    for (int u = 0; u < U; ++u)
      store(s.y1 + first + kGroup * u, y1[u]), store(s.y2 + first + kGroup * u, y2[u]);
  }

  /// Two samples a step, from...to even; the sums of earlier groups are in `sum`, unless these are the first.
  template <int kDriven, int kFirst>
  void run(int from, int to, const double* x, double* sum) {
#pragma GCC unroll 2
    for (int n = from; n < to; n += 2) {
      V even = kFirst ? V{} : load_aligned(sum + kGroup * n),
        odd = kFirst ? V{} : load_aligned(sum + kGroup * n + kGroup);
#pragma GCC unroll 5
      for (int u = 0; u < U; ++u) {
        y2[u] = b2[u] * y2[u] + a1[u] * y1[u];
        if (kDriven) y2[u] += in[u] * x[n];
        even = kFirst && u == 0 ? y2[u] : even + y2[u];
        y1[u] = b2[u] * y1[u] + a1[u] * y2[u];
        if (kDriven) y1[u] += in[u] * x[n + 1];
        odd = kFirst && u == 0 ? y1[u] : odd + y1[u];
      }
      store(sum + kGroup * n, even);
      store(sum + kGroup * n + kGroup, odd);
    }
  }

  V a1[U], b2[U], in[U], y1[U], y2[U];  // b2 with its sign turned: SSE2 saves a move
};

template <int U, int kFirst>
void run_groups(ModesState& s, const ModesDrive& drive, int first, double* sum) {
  for (int i = 0; i < kParts; ++i) {
    const int k = first + W * i;
    Modes<U> modes(s, k);
    if (drive.first == drive.last) {
      modes.template run<0, kFirst>(0, kChunk, drive.x, sum + W * i);
    } else {
      modes.template run<0, kFirst>(0, drive.first, drive.x, sum + W * i);
      modes.template run<1, kFirst>(drive.first, drive.last, drive.x, sum + W * i);
      modes.template run<0, kFirst>(drive.last, kChunk, drive.x, sum + W * i);
    }
    modes.keep(s, k);
  }
}

template <int kFirst>
int run_some(ModesState& s, const ModesDrive& drive, int group, double* sum) {
  const int left = s.groups - group, first = kGroup * group;
  if (left == 5) return run_groups<5, kFirst>(s, drive, first, sum), 5;
  if (left >= 4) return run_groups<4, kFirst>(s, drive, first, sum), 4;
  if (left == 3) return run_groups<3, kFirst>(s, drive, first, sum), 3;
  if (left == 2) return run_groups<2, kFirst>(s, drive, first, sum), 2;
  return run_groups<1, kFirst>(s, drive, first, sum), 1;
}

/// Four samples from four lanes each: (lane 0 + lane 1) + (lane 2 + lane 3).
inline void add_lanes(const double* lanes, double* out) {
#if RIGSOUND_LANES == 4
  const V a = load_aligned(lanes), b = load_aligned(lanes + 4), c = load_aligned(lanes + 8),
          d = load_aligned(lanes + 12);
  const V ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const V cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  store(out, __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
#else
  for (int n = 0; n < 4; n += 2) {
    const V a = load(lanes + 4 * n), b = load(lanes + 4 * n + 2);
    const V c = load(lanes + 4 * n + 4), d = load(lanes + 4 * n + 6);
    store(out + n, (__builtin_shufflevector(a, c, 0, 2) + __builtin_shufflevector(a, c, 1, 3)) +
                       (__builtin_shufflevector(b, d, 0, 2) + __builtin_shufflevector(b, d, 1, 3)));
  }
#endif
}

void modes(ModesState& s, const ModesDrive& drive, double* out) noexcept {
  alignas(32) double sum[kGroup * kChunk];
  int group = run_some<1>(s, drive, 0, sum);
  while (group < s.groups) group += run_some<0>(s, drive, group, sum);
#pragma GCC unroll 2
  for (int n = 0; n < kChunk; n += 4) add_lanes(sum + kGroup * n, out + n);
}

void tune(ModesState& s, const ModesTuning& tuning, int group) noexcept {
  const TableCut& cut = tuning.cut;
  for (int i = 0; i < kParts; ++i) {
    const int k = kGroup * group + W * i;
    const V y = load(s.y1 + k), x = (load(s.c + k) * y - load(s.b2 + k) * load(s.y2 + k)) / load(s.s + k);
    const V t = (cut.weight[0] * load(cut.row[0] + k) + cut.weight[1] * load(cut.row[1] + k)) +
                (cut.weight[2] * load(cut.row[2] + k) + cut.weight[3] * load(cut.row[3] + k));
    const V t2 = t * t, u = held((t - tuning.fade_from) * tuning.fade_scale), fade = u * u * (3 - 2 * u);
    const V r = 1 - ((tuning.loss + tuning.loss_slope * t2) + tuning.fade_loss * fade);
    const V unit = r / (1 + t2), c = (1 - t2) * unit, sin = (t + t) * unit, r2 = r * r;
    store(s.a1 + k, c + c);
    store(s.b2 + k, r2);
    store(s.c + k, c);
    store(s.s + k, sin);
    store(s.in + k, sin * (tuning.gain * (1 - fade)));
    store(s.y2 + k, (y * c - x * sin) / r2);
  }
}

}  // namespace
}  // namespace rigsound::string
