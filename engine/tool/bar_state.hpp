// Everything a ringing bar remembers from sample to sample, and the coefficients it runs with.
#pragma once

#include <cstdint>

#include "rigsound/limits.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::tool {

constexpr int kLanes = kMaxSections + kMaxLongSections;  ///< both families' sections side by side
constexpr int kPaperLanes = kMaxPaperSections;
constexpr int kRing = 1024;  ///< samples the delay lines remember, a power of two
static_assert(kRing > kMaxLoopDelay && kLanes % 4 == 0 && kPaperLanes % 4 == 0);

/// Index of a family in every pair of numbers.
enum Family : int { kTransversal, kLongitudinal };

/// Second-order sections in orthogonal form, one a lane. With m the doubled implicit midpoint:
///   m = (g0 x1 - g1 x2) + g2 u,  y = u - h m,  x1' = m - x1,  x2' = x2 + e m
/// keeps y^2 + x1'^2 + x2'^2 = u^2 + x1^2 + x2^2 for whatever b, c > 0 it is set to, and to whatever it is
/// set from sample to sample. With c = 0 it is a first-order section with its sign turned.
struct SectionLanes {
  alignas(16) double g0[kLanes], g1[kLanes], g2[kLanes], h[kLanes], e[kLanes];
  alignas(16) double x1[kLanes], x2[kLanes];
  alignas(16) double y[kLanes];  ///< each lane's last output
};

/// The paper's identical first-order sections (eq. 5): y = lambda u + s, s' = u - lambda y.
struct PaperLanes {
  double lambda;
  alignas(16) double s[kPaperLanes], y[kPaperLanes];
};

/// Plain arrays: the kernels' source files must not instantiate anything the linker could merge.
struct BarState {
  SectionLanes sections;
  PaperLanes paper;

  alignas(16) double ring[kRing][2];  ///< both delay lines, interleaved
  unsigned at;                        ///< samples written to it
  unsigned delay[2];                  ///< what is left of N beside the lanes, >= 1

  // DC blocker b = dc_d v + dc_s, dc_s' = dc_r b - dc_d v; shelf w = sh_0 b + sh_s, sh_s' = sh_1 b + sh_q w.
  alignas(16) double dc_d[2], dc_r[2], dc_s[2];
  alignas(16) double sh_0[2], sh_1[2], sh_q[2], sh_s[2];

  // High-pass after the mix: out = hp_b (m - hp_m) + hp_p out.
  double hp_b, hp_p, hp_m, hp_out;

  // Where each family's first section sits: all bits set in that lane only, so that an OR drops the delay
  // line's sample among the idle lanes before it.
  alignas(16) std::uint64_t entry[2][4];
  int vectors[2];  ///< of the lane width in use, per family
  int last[2];     ///< lane whose output leaves the cascade
};

/// What one chunk is driven with. Everything but x is constant when nothing changes.
struct BarDrive {
  int frames = kChunk;  ///< 1...kChunk
  alignas(16) double x[kChunk];
  alignas(16) double k[kChunk][2];
  alignas(16) double mix[kChunk][2];
};

/// Sets one section; its state may stay as it is. Thread: RT.
void set_section(SectionLanes& lanes, int lane, double b, double c) noexcept;

/// What the bar still holds: squares of everything in flight, of the sections, and the storage of DC blocker
/// and shelf. Never grows while x = 0 and |k| <= 1. Thread: RT.
double energy(const BarState& state) noexcept;

/// Exact silence; the coefficients stay. Thread: RT.
void silence(BarState& state) noexcept;

}  // namespace rigsound::tool
