// The inner loops of the drill string, once per vector width. All widths compute the same bits: four logical
// lanes never mix but in one written sum.
#pragma once

#include "rigsound/dsp/lane_width.hpp"
#include "string/string_state.hpp"

namespace rigsound::string {

/// Input and sound of the lines, kChunk samples each.
struct LinesDrive {
  const double* in;    ///< strikes the shank
  const double* snap;  ///< acts at the cut, if there is one
  double* heard;       ///< the waves that leave the shank's free end, and the cut
};

/// Input of the modes, kChunk samples; zero outside first...last.
struct ModesDrive {
  const double* x;
  int first, last;
};

struct StringKernel {
  /// Samples from...from + frames of a chunk through the shank and all joints; leaves the downward wave at
  /// the bit in state.down. `frames` must be a whole number of sleeves that no line is shorter than, the
  /// shank's excepted where a joint follows it. Thread: RT.
  void (*lines)(LinesState& state, const LinesDrive& drive, int from, int frames) noexcept;

  /// kChunk samples of all sounding modes to `out`. Thread: RT.
  void (*modes)(ModesState& state, const ModesDrive& drive, double* out) noexcept;

  /// Tunes one group anew; what rings in it goes on. Thread: RT.
  void (*tune)(ModesState& state, const ModesTuning& tuning, int group) noexcept;

  /// kChunk samples: `sound` holds the string's waves and gets the mix with `bending`, high-passed. Thread:
  /// RT.
  void (*voice)(VoiceState& state, const double* bending, double* sound) noexcept;
};

/// Thread: any.
const StringKernel& string_kernel(dsp::LaneWidth width) noexcept;

}  // namespace rigsound::string
