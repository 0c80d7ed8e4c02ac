// The inner loop of the longitudinal string, for the lane width RIGSOUND_LANES.
#pragma once

#include "string/vector_lanes.hpp"

namespace rigsound::string {
namespace {

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

}  // namespace
}  // namespace rigsound::string
