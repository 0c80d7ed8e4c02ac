// Levels of a sound in dB: per third of an octave, and above 12 kHz.
#pragma once

#include <vector>

namespace rigsound::tests {

/// Energy per third of an octave, 125 Hz...15 kHz, as if the sound were continuous in time: the same whatever
/// rate it was sampled at.
std::vector<double> third_octaves_db(const std::vector<double>& sound, double rate);

/// Largest difference in any band between any two of `sounds`.
double largest_difference_db(const std::vector<std::vector<double>>& levels);

/// Peak of what lies above 12 kHz within `from_s`...`to_s` against the peak of the whole sound: a
/// linear-phase high-pass of 513 taps under a Blackman-Harris window.
double residue_db(const std::vector<double>& sound, double rate, double from_s, double to_s);

}  // namespace rigsound::tests
