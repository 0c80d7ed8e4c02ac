// Everything a ringing bar remembers from sample to sample, and the coefficients it runs with.
#pragma once

#include <cstdint>

#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::tool {

constexpr int kLanes = kMaxSections + kMaxLongSections;  ///< both families' sections side by side
constexpr int kPaperLanes = kMaxPaperSections;
constexpr int kLineSlack = 256;  ///< samples a delay line takes before it is moved back to its start
constexpr int kLine = kMaxLoopDelay + 8 + kLineSlack;
static_assert(kLanes % 4 == 0 && kPaperLanes % 4 == 0);

/// Index of a family in every pair of numbers.
enum Family : int { kTransversal, kLongitudinal };

/// Second-order sections, one a lane. With w = g0 x1 - g1 x2 and m = w + g2 u (the doubled implicit
/// midpoint):
///   y = c0 u - h w,  x1' = m - x1,  x2' = x2 + m
/// keeps y^2 + x1'^2 + (e x2')^2 = u^2 + x1^2 + (e x2)^2: energy is neither made nor lost, whatever b, c > 0
/// it is set to, and to whatever it is set from sample to sample. With c = 0 it is a first-order section with
/// its sign turned; its x2 then weighs nothing.
struct SectionLanes {
  alignas(32) double g0[kLanes], g1[kLanes], g2[kLanes], c0[kLanes], h[kLanes], e[kLanes];
  alignas(32) double x1[kLanes], x2[kLanes];
  alignas(32) double y[kLanes];  ///< each lane's last output
};

/// The paper's identical first-order sections (eq. 5), y = lambda (u - y_1) + u_1: every lane's outputs of
/// the last two samples are all there is to remember, since one section's input is another's output.
struct PaperLanes {
  double lambda;
  int turn;  ///< y[turn]: of the sample before last; the other: of the last
  alignas(32) double y[2][kPaperLanes];
  /// Where the first section sits among the first vectors: all bits set in that lane only, so that an OR
  /// drops the delay line's sample among the idle lanes.
  alignas(32) std::uint64_t entry[4][4];
};

/// Where a family sits among the lanes, W to a vector: slot s of its V vectors is vector s % V, lane s / V,
/// so that all but one vector in V get their input from the vector before without moving lanes. Its slots are
/// first ... end - 1, its sections the last of them; those before hand on a sample later what they get, for
/// which the delay line is shorter. The paper's lanes cannot: they idle at zero.
///
/// A longitudinal family whose few sections fit into the lanes the transversal one leaves idle has no vectors
/// of its own: it takes lane 0 of the same ones (base 0, end V), the transversal family the lanes above
/// (first V).
struct Seats {
  int base;        ///< first vector
  int vectors;     ///< V
  int first, end;  ///< in slots

  constexpr int skew() const noexcept { return end - first - 1; }  ///< samples the lanes delay by, all in all

  constexpr int lane(int slot, int width) const noexcept {
    return width * (base + slot % vectors) + slot / vectors;
  }
};

/// Plain arrays: the kernels' source files must not instantiate anything the linker could merge.
struct BarState {
  SectionLanes sections;
  PaperLanes paper;

  alignas(64) double line[kLine][2];  ///< y of both families, oldest first
  int at;                             ///< where in it the next sample goes
  int line_end;                       ///< how far it may grow before make_room()
  int delay[2];                       ///< what is left of N beside the lanes, >= 1

  // DC blocker b = v + dc_s, dc_s' = dc_r b - v; shelf w = sh_0 b + sh_s, sh_s' = sh_1 b + sh_q w. The DC
  // blocker's gain, dc_gain(), is in the shelf's coefficients.
  alignas(32) double dc_r[2], dc_s[2];
  alignas(32) double sh_0[2], sh_1[2], sh_q[2], sh_s[2];

  // High-pass of each family: r = hp_b (y - y_1) + hp_p r_1.
  double hp_b, hp_p;
  alignas(32) double hp_r[2];

  Seats seats[2];  ///< of the lane width in use, per family
  int last[2];     ///< lane whose output leaves the cascade
};

/// What a stretch of at most kChunk samples is driven with, `frames` values each.
struct BarDrive {
  int frames = kChunk;
  bool struck = false;  ///< some x is not zero
  const double* x = nullptr;
  const double* k[2] = {};    ///< reflection of each family, |k| <= 1
  const double* mix[2] = {};  ///< weight of each family
};

/// Gain of a DC blocker with this pole that makes it 1 at half the sample rate, and passive.
constexpr double dc_gain(double dc_r) noexcept { return (1 + dc_r) / 2; }

/// How far back in the line anything still looks, samples.
int reach(const BarState& state) noexcept;

/// Moves the line back to its start if `frames` more samples do not fit. Thread: RT.
void make_room(BarState& state, int frames) noexcept;

/// Sets one section. Its energy stays what it is. Thread: RT.
void set_section(SectionLanes& lanes, int lane, double b, double c) noexcept;

/// What the bar still holds: squares of everything in flight, of the sections, and the storage of DC blocker
/// and shelf. Never grows while x = 0 and |k| <= 1. Thread: RT.
double energy(const BarState& state) noexcept;

/// Exact silence; the coefficients stay. Thread: RT.
void silence(BarState& state) noexcept;

}  // namespace rigsound::tool
