// What the drill string remembers from sample to sample, and the coefficients its inner loops run with.
#pragma once

#include <cstdint>

#include "rigsound/machine/limits.hpp"
#include "string/design/mode_table.hpp"
#include "string/design/string_tuning.hpp"

namespace rigsound::string {

constexpr int kMaxSleeve = 4 * kSleeveStep;

/// Plain arrays: the kernels' source files must not instantiate anything the linker could merge.
///
/// Line j is the upward wave of the shank (0) or of a rod: its sample n goes to line[j][at + n], and what
/// went in delay[j] samples earlier comes out. Waves of force, the rod's impedance being 1.
struct LinesState {
  double* line[kMaxLines];
  int delay[kMaxLines];
  int at;  ///< where in every line the next sample goes
  int joints;
  int cut;  ///< joint at which the string is broken, -1: none
  int sleeve_steps;
  int has_taps;
  double tap[kMaxLines][3];                         ///< of the rods' lines, see StringTuning
  double rho;                                       ///< reflection from rod to sleeve
  alignas(32) double sleeve[kMaxRods][kMaxSleeve];  ///< upward wave in every sleeve, next out first

  double loss_middle, loss_side;  ///< reflection at the shank's free end, see StringTuning
  // Thiran allpass there: y = a2 u + s1, s1' = a1 (u - y) + s2, s2' = u - a2 y.
  double a1, a2, s1, s2;

  alignas(32) double down[kChunk];  ///< of the block at hand: downward wave at the bit
};

/// Bending modes, kGroup side by side. A mode that is r times as large one turn of its angle later:
///   y = a1 y_1 - b2 y_2 + in x, a1 = 2 r cos, b2 = r^2.
/// The pair y_1 and q = (c y_1 - b2 y_2) / s, c = r cos, s = r sin, only turns and shrinks by r a sample, so
/// the coefficients may be exchanged in that form at any time: q^2 + y_1^2 never grows.
struct ModesState {
  int groups;  ///< that sound
  alignas(32) double a1[kMaxModes], b2[kMaxModes], in[kMaxModes];
  alignas(32) double c[kMaxModes], s[kMaxModes];
  alignas(32) double y1[kMaxModes], y2[kMaxModes];  ///< last output and the one before
};

/// Mix m = string_mix u + v, and a high-pass y = hp_b (m - m_1) + hp_p y_1.
struct VoiceState {
  double string_mix, hp_b, hp_p;
  double hp_x, hp_y;
};

/// What modes are tuned to: 1 - r = loss + loss_slope t^2 + fade_loss fade, t = tan(pi f / rate); fade goes
/// from 0 at fade_from to 1 at fade_from + 1 / fade_scale, in t.
struct ModesTuning {
  TableCut cut;
  double loss = 0, loss_slope = 0;
  double fade_from = 0, fade_scale = 1, fade_loss = 0;
  double gain = 1;
};

}  // namespace rigsound::string
