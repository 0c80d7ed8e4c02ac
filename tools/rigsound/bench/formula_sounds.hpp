// A sound set made from formulas: what benchmarks and tests of the engine play, with no files to read.
#pragma once

#include "rigsound/engine.hpp"

namespace rigsound::tools {

/// One bank per situation (noise bursts of the situation's rate and decay), one tool, one background.
/// The same bits everywhere: it is computed with the engine's own functions.
SoundSet formula_sounds(double sample_rate = 48000);

/// Two booms, one with a tool, an equaliser: every part of the engine is at work.
EngineOptions full_options(int block = 64);

/// The state of a drilled hole at `second`: all situations, both rattlings, percussion off, changing RPM.
/// Runs through its phases once a minute.
MachineState drilled_hole(double second);

}  // namespace rigsound::tools
