// Frequency weightings A and C of sound level meters (IEC 61672-1).
#pragma once

#include "rigsound/dsp/biquad.hpp"

namespace rigsound::dsp {

/// A = C and one section more. Unity gain at 1 kHz each.
struct Weighting {
  BiquadCoefficients c[2], a;
};

/// Within the class 1 tolerances of the standard, whose poles these are (annex E), at 32 kHz and more.
/// Thread: OFF.
Weighting weighting(double sample_rate);

/// Gains of the analogue filters at `frequency_hz`, linear, 1 at 1 kHz. Thread: OFF.
double analogue_a_gain(double frequency_hz);
double analogue_c_gain(double frequency_hz);

}  // namespace rigsound::dsp
