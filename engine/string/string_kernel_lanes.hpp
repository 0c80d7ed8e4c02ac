// The inner loops, for the lane width RIGSOUND_LANES. Included by one source file per width; everything has
// internal linkage, because the linker must not merge code compiled for different processors.
#pragma once

#include <cstring>

#include "string/string_kernel.hpp"

namespace rigsound::string {
namespace {

constexpr int W = RIGSOUND_LANES;
constexpr int kParts = kGroup / W;  // vectors that hold a group
using V __attribute__((vector_size(W * sizeof(double)))) = double;
using Bits __attribute__((vector_size(W * sizeof(double)))) = std::int64_t;

inline V load(const double* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

inline void store(double* to, V v) { std::memcpy(to, &v, sizeof v); }

inline V everywhere(double x) { return V{} + x; }

inline V kept(V v, Bits where) { return (V)((Bits)v & where); }

/// v held within 0...1.
inline V held(V v) {
  const Bits above = v >= everywhere(1);
  return kept(kept(v, v > V{}), ~above) + kept(everywhere(1), above);
}

/// Both junctions of a joint, one multiplication each; Q: sleeve_steps.
template <int Q>
inline void scatter(double* down, double* up, const double* below, double* sleeve, double rho, int frames) {
  constexpr int N = Q * kSleeveStep / W;
  V inside[N];
  for (int i = 0; i < N; ++i) inside[i] = load(sleeve + W * i);
  const V r = everywhere(rho);
#pragma GCC unroll 2
  for (int n = 0; n < frames; n += Q * kSleeveStep) {
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) {
      const int m = n + W * i;
      const V above = load(down + m), w = r * (above - inside[i]);
      store(up + m, inside[i] + w);
      const V through = above + w, from_rod = load(below + m), w2 = r * (through - from_rod);
      inside[i] = from_rod - w2;
      store(down + m, through - w2);
    }
  }
  for (int i = 0; i < N; ++i) store(sleeve + W * i, inside[i]);
}

/// Two free ends where the string is broken; the lower one is heard too.
inline void part(double* down, double* up, const double* below, const double* snap, double* heard,
                 int frames) {
  for (int n = 0; n < frames; n += W) {
    const V pulse = load(snap + n);
    store(up + n, pulse - load(down + n));
    const V lower = V{} - pulse - load(below + n);
    store(down + n, lower);
    store(heard + n, load(heard + n) + lower);
  }
}

/// The allpass of the shank's free end, in locals.
struct FreeEnd {
  explicit FreeEnd(const LinesState& s)
      : g0(s.g0), g1(s.g1), g2(s.g2), c0(s.c0), h(s.h), x1(s.x1), x2(s.x2) {}

  double pass(double u) {
    const double w = g0 * x1 - g1 * x2, m = w + g2 * u, y = c0 * u - h * w;
    x1 = m - x1;
    x2 = x2 + m;
    return y;
  }

  double g0, g1, g2, c0, h, x1, x2;
};

/// `frames` samples reflected at the free end and struck: to `down`.
inline void reflect(const LinesState& s, const double* arrived, const double* in, FreeEnd& end, double* down,
                    int frames) {
  const V middle = everywhere(s.loss_middle), side = everywhere(s.loss_side);
#pragma GCC unroll 4
  for (int n = 0; n < frames; n += W)
    store(down + n, middle * load(arrived + n - 1) + side * (load(arrived + n) + load(arrived + n - 2)));
#pragma GCC unroll 4
  for (int n = 0; n < frames; ++n) down[n] = in[n] - end.pass(down[n]);
}

/// Joint `j` for the block's samples from `n`.
template <int Q>
inline void pass_joint(LinesState& s, const LinesDrive& drive, int j, int from, int n, int frames) {
  double* const up = s.line[j] + s.at + from + n;
  const double* const below = s.line[j + 1] + s.at + from + n - s.delay[j + 1];
  if (j == s.cut)
    part(s.down + n, up, below, drive.snap + from + n, drive.heard + from + n, frames);
  else
    scatter<Q>(s.down + n, up, below, s.sleeve[j], s.rho, frames);
}

/// The shank's round trip may be as short as a sleeve's, so its joint goes sleeve by sleeve.
template <int Q>
void run_lines(LinesState& s, const LinesDrive& drive, int from, int frames) noexcept {
  FreeEnd end(s);
  const double* const arrived = s.line[0] + s.at + from - s.delay[0];
  const int step = s.joints > 0 ? Q * kSleeveStep : frames;
  for (int n = 0; n < frames; n += step) {
    reflect(s, arrived + n, drive.in + from + n, end, s.down + n, step);
    std::memcpy(drive.heard + from + n, s.down + n, static_cast<std::size_t>(step) * sizeof(double));
    if (s.joints > 0) pass_joint<Q>(s, drive, 0, from, n, step);
  }
  s.x1 = end.x1, s.x2 = end.x2;
  for (int j = 1; j < s.joints; ++j) pass_joint<Q>(s, drive, j, from, 0, frames);
}

void lines(LinesState& s, const LinesDrive& drive, int from, int frames) noexcept {
  if (s.sleeve_steps == 1)
    run_lines<1>(s, drive, from, frames);
  else if (s.sleeve_steps == 2)
    run_lines<2>(s, drive, from, frames);
  else
    run_lines<4>(s, drive, from, frames);
}

/// U groups at a time: a part of each, its coefficients and state in registers.
template <int U>
struct Modes {
  Modes(const ModesState& s, int first) {
    for (int u = 0; u < U; ++u) {
      const int k = first + kGroup * u;
      a1[u] = load(s.a1 + k), b2[u] = load(s.b2 + k), in[u] = load(s.in + k);
      y1[u] = load(s.y1 + k), y2[u] = load(s.y2 + k);
    }
  }

  void keep(ModesState& s, int first) const {
    for (int u = 0; u < U; ++u)
      store(s.y1 + first + kGroup * u, y1[u]), store(s.y2 + first + kGroup * u, y2[u]);
  }

  /// Two samples a step, from...to even; the sums of earlier groups are in `sum`, unless these are the first.
  template <int kDriven, int kFirst>
  void run(int from, int to, const double* x, double* sum) {
#pragma GCC unroll 2
    for (int n = from; n < to; n += 2) {
      V even = kFirst ? V{} : load(sum + kGroup * n), odd = kFirst ? V{} : load(sum + kGroup * n + kGroup);
#pragma GCC unroll 4
      for (int u = 0; u < U; ++u) {
        y2[u] = a1[u] * y1[u] - b2[u] * y2[u];
        if (kDriven) y2[u] += in[u] * x[n];
        even = kFirst && u == 0 ? y2[u] : even + y2[u];
        y1[u] = a1[u] * y2[u] - b2[u] * y1[u];
        if (kDriven) y1[u] += in[u] * x[n + 1];
        odd = kFirst && u == 0 ? y1[u] : odd + y1[u];
      }
      store(sum + kGroup * n, even);
      store(sum + kGroup * n + kGroup, odd);
    }
  }

  V a1[U], b2[U], in[U], y1[U], y2[U];
};

template <int U, int kFirst>
void run_groups(ModesState& s, const ModesDrive& drive, int first, double* sum) {
  for (int i = 0; i < kParts; ++i) {
    const int k = first + W * i;
    Modes<U> modes(s, k);
    modes.template run<0, kFirst>(0, drive.first, drive.x, sum + W * i);
    modes.template run<1, kFirst>(drive.first, drive.last, drive.x, sum + W * i);
    modes.template run<0, kFirst>(drive.last, kChunk, drive.x, sum + W * i);
    modes.keep(s, k);
  }
}

template <int kFirst>
int run_some(ModesState& s, const ModesDrive& drive, int group, double* sum) {
  const int left = s.groups - group, first = kGroup * group;
  if (left >= 4) return run_groups<4, kFirst>(s, drive, first, sum), 4;
  if (left == 3) return run_groups<3, kFirst>(s, drive, first, sum), 3;
  if (left == 2) return run_groups<2, kFirst>(s, drive, first, sum), 2;
  return run_groups<1, kFirst>(s, drive, first, sum), 1;
}

void modes(ModesState& s, const ModesDrive& drive, double* out) noexcept {
  alignas(32) double sum[kGroup * kChunk];
  int group = run_some<1>(s, drive, 0, sum);
  while (group < s.groups) group += run_some<0>(s, drive, group, sum);
  for (int n = 0; n < kChunk; ++n) {
    const double* const lane = sum + kGroup * n;
    out[n] = (lane[0] + lane[1]) + (lane[2] + lane[3]);
  }
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

constexpr StringKernel kKernel = {lines, modes, tune};

}  // namespace
}  // namespace rigsound::string
