// What a loop does at a complex frequency: phase, delay, gain, and the poles that ring.
//
// Everything is written in p = tanh(s / 2), s = (ln r + i omega) per sample, where the bilinear sections
// are rational functions of low degree.
#pragma once

#include "rigsound/dsp/complex.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::tool {

/// p at z = e^s.
dsp::Complex bilinear(dsp::Complex s) noexcept;

/// Phase lag of the allpass at `omega` rad/sample, unwrapped (0 at DC, rising to order * pi).
double lag(const Allpass& allpass, double omega) noexcept;

/// Its derivative, samples.
double group_delay(const Allpass& allpass, double omega) noexcept;

/// Phase lag of DC blocker and shelf, -pi...pi.
double lag(const LoopFilters& filters, double omega) noexcept;

dsp::Complex response(const Allpass& allpass, dsp::Complex p) noexcept;
dsp::Complex response(const LoopFilters& filters, dsp::Complex p) noexcept;

/// A mode of a closed loop.
struct Pole {
  double omega = 0;  ///< rad/sample
  double sigma = 0;  ///< ln of the amplitude ratio from one sample to the next, negative
};

/// The pole of y = x + k F A z^-N y nearest `omega` (Newton; within 1e-13).
Pole closed_loop_pole(const LoopDesign& loop, double k, double omega) noexcept;

/// Decay rate the loop gives a wave of frequency `omega` whether or not a pole lies there: ln of the
/// amplitude ratio from one sample to the next. At a pole this is the pole's sigma.
double decay_rate(const LoopDesign& loop, double k, double omega) noexcept;

/// T60 in samples of a decay rate.
inline double t60_samples(double sigma) noexcept { return 3 * dsp::kLn10 / -sigma; }

}  // namespace rigsound::tool
