// Second-order sections in a row: the colours of simulated sounds.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// One section, a0 = 1, transposed direct form II.
struct Biquad {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

using BiquadCascade = std::vector<Biquad>;

/// Audio EQ Cookbook filters (Bristow-Johnson) at 48 kHz; `f` in Hz, `gain_db` in dB.
Biquad peaking(double f, double gain_db, double q);
Biquad highpass(double f, double q = 0.7071);
Biquad high_shelf(double f, double gain_db);  ///< wide (Q 0.5), half of the gain at `f`

/// First-order lowpass with its pole at exp(-2 pi f / fs).
Biquad one_pole(double f);

/// Filters `x` in place from rest, section by section.
void filter(const BiquadCascade& sections, std::vector<double>& x);

}  // namespace rigsound::analysis
