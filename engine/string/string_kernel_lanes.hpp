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

/// The same from an address that is a multiple of the vector's size; SSE2 then loads where it computes.
inline V load_aligned(const double* from) {
  V v;
  std::memcpy(&v, __builtin_assume_aligned(from, sizeof v), sizeof v);
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

/// What comes out of a rod's line, read at the place: as it is, or between samples.
struct Whole {
  explicit Whole(const double*) {}
  V read(const double* at) const { return load(at); }
};

struct Between {
  explicit Between(const double* tap) : a(everywhere(tap[0])), b(everywhere(tap[1])), c(everywhere(tap[2])) {}
  V read(const double* at) const { return (a * load(at) + c * load(at - 2)) + b * load(at - 1); }
  V a, b, c;
};

/// Both junctions of a joint, one multiplication each. Q: sleeve_steps; F: samples.
template <int Q, int F, class Rod>
inline void scatter(double* down, double* up, const double* below, double* sleeve, double rho, Rod rod) {
  constexpr int N = Q * kSleeveStep / W;
  V inside[N];
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) inside[i] = load(sleeve + W * i);
  const V r = everywhere(rho);
#pragma GCC unroll 8
  for (int n = 0; n < F; n += Q * kSleeveStep) {
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) {
      const int m = n + W * i;
      const V above = load_aligned(down + m), w = r * (above - inside[i]);
      store(up + m, inside[i] + w);
      const V through = above + w, from_rod = rod.read(below + m), w2 = r * (through - from_rod);
      inside[i] = from_rod - w2;
      store(down + m, through - w2);
    }
  }
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) store(sleeve + W * i, inside[i]);
}

/// Two free ends where the string is broken; the lower one is heard too.
template <int F, class Rod>
void part(double* down, double* up, const double* below, const double* snap, double* heard, Rod rod) {
  for (int n = 0; n < F; n += W) {
    const V pulse = load(snap + n);
    store(up + n, pulse - load(down + n));
    const V lower = V{} - pulse - rod.read(below + n);
    store(down + n, lower);
    store(heard + n, load(heard + n) + lower);
  }
}

/// The reflection at the shank's free end, in locals.
struct FreeEnd {
  explicit FreeEnd(const LinesState& s)
      : middle(everywhere(s.loss_middle)),
        side(everywhere(s.loss_side)),
        a1(s.a1),
        a2(s.a2),
        s1(s.s1),
        s2(s.s2) {}

  /// F samples that arrived, reflected and struck: to `down`.
  template <int F>
  void reflect(const double* arrived, const double* in, double* down) {
    alignas(32) double u[F];
#pragma GCC unroll 16
    for (int n = 0; n < F; n += W)
      store(u + n, middle * load(arrived + n - 1) + side * (load(arrived + n) + load(arrived + n - 2)));
#pragma GCC unroll 8
    for (int n = 0; n < F; ++n) {
      const double y = a2 * u[n] + s1;
      s1 = a1 * (u[n] - y) + s2;
      s2 = u[n] - a2 * y;
      down[n] = in[n] - y;
    }
  }

  V middle, side;
  double a1, a2, s1, s2;
};

/// Where one block's waves go.
struct Places {
  Places(const LinesState& s, const LinesDrive& drive, int from)
      : at(s.at + from), in(drive.in + from), snap(drive.snap + from), heard(drive.heard + from) {}

  double* up(const LinesState& s, int j) const { return s.line[j] + at; }
  const double* arrived(const LinesState& s, int j) const { return s.line[j] + at - s.delay[j]; }

  int at;
  const double *in, *snap;
  double* heard;
};

/// N samples at a time from the shank's end through the first joint, which only `kParted` breaks.
template <int Q, int N, int kParted, class Rod>
inline void run_head(LinesState& s, const Places& at, int frames) {
  FreeEnd end(s);
  const Rod rod(s.tap[1]);
  double* const up = at.up(s, 0);
  const double* const arrived = at.arrived(s, 0);
  const double* const below = at.arrived(s, 1);
  for (int n = 0; n < frames; n += N) {
    end.reflect<N>(arrived + n, at.in + n, s.down + n);
    std::memcpy(at.heard + n, s.down + n, N * sizeof(double));
    if (kParted)
      part<N>(s.down + n, up + n, below + n, at.snap + n, at.heard + n, rod);
    else
      scatter<Q, N>(s.down + n, up + n, below + n, s.sleeve[0], s.rho, rod);
  }
  s.s1 = end.s1, s.s2 = end.s2;
}

/// Joints from...to, none of them broken.
template <int Q, int F, class Rod>
inline void run_joints(LinesState& s, const Places& at, int from, int to) {
  for (int j = from; j < to; ++j)
    scatter<Q, F>(s.down, at.up(s, j), at.arrived(s, j + 1), s.sleeve[j], s.rho, Rod(s.tap[j + 1]));
}

/// F samples through a string with joints. The shank's round trip may be as short as a sleeve's, so its joint
/// goes sleeve by sleeve.
template <int Q, int F, class Rod>
void run_jointed(LinesState& s, const LinesDrive& drive, int from) {
  constexpr int kStep = Q * kSleeveStep;
  const Places at(s, drive, from);
  if (s.cut == 0)
    run_head<Q, kStep, 1, Rod>(s, at, F);
  else
    run_head<Q, kStep, 0, Rod>(s, at, F);
  run_joints<Q, F, Rod>(s, at, 1, s.cut > 0 ? s.cut : s.joints);
  if (s.cut <= 0) return;
  part<F>(s.down, at.up(s, s.cut), at.arrived(s, s.cut + 1), at.snap, at.heard, Rod(s.tap[s.cut + 1]));
  run_joints<Q, F, Rod>(s, at, s.cut + 1, s.joints);
}

template <int Q, int F>
void run_lines(LinesState& s, const LinesDrive& drive, int from) {
  if (s.joints > 0) {
    s.has_taps ? run_jointed<Q, F, Between>(s, drive, from) : run_jointed<Q, F, Whole>(s, drive, from);
    return;
  }
  const Places at(s, drive, from);
  FreeEnd end(s);
  end.reflect<F>(at.arrived(s, 0), at.in, s.down);
  s.s1 = end.s1, s.s2 = end.s2;
  std::memcpy(at.heard, s.down, F * sizeof(double));
}

template <int Q>
void run_block(LinesState& s, const LinesDrive& drive, int from, int frames) {
  constexpr int kStep = Q * kSleeveStep;
  if (frames == kChunk)
    run_lines<Q, kChunk>(s, drive, from);
  else if (frames >= 2 * kStep)
    run_lines<Q, 2 * kStep>(s, drive, from);
  else
    run_lines<Q, kStep>(s, drive, from);
}

void lines(LinesState& s, const LinesDrive& drive, int from, int frames) noexcept {
  if (s.sleeve_steps == 1)
    run_block<1>(s, drive, from, frames);
  else if (s.sleeve_steps == 2)
    run_block<2>(s, drive, from, frames);
  else
    run_block<4>(s, drive, from, frames);
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

void voice(VoiceState& s, const double* bending, double* sound) noexcept {
  alignas(32) double rise[kChunk + W];  // from sample to sample, W places late
  const V mix = everywhere(s.string_mix), b = everywhere(s.hp_b);
  double y = s.hp_y;
  rise[W - 1] = s.hp_x;
#pragma GCC unroll 4
  for (int n = 0; n < kChunk; n += W) store(rise + W + n, mix * load(sound + n) + load(bending + n));
  s.hp_x = rise[W + kChunk - 1];
#pragma GCC unroll 4
  for (int n = 0; n < kChunk; n += W) store(sound + n, b * (load(rise + W + n) - load(rise + W + n - 1)));
#pragma GCC unroll 8
  for (int n = 0; n < kChunk; ++n) sound[n] = y = sound[n] + s.hp_p * y;
  s.hp_y = y;
}

constexpr StringKernel kKernel = {lines, modes, tune, voice};

}  // namespace
}  // namespace rigsound::string
