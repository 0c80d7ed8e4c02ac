// How far one pitched spectrum is from another at, near and between the harmonics.
#pragma once

#include <array>
#include <vector>

namespace rigsound::analysis {

struct HarmonicError {
  double at_db = 0;       ///< within 1/8 of f0 around the harmonics
  double near_db = 0;     ///< 1/8 ... 1/4
  double between_db = 0;  ///< over 1/4
};

/// rms over harmonics 1 ... `highest` of the band power ratio, dB. `a`, `b`: P angle samples a period, P a
/// power of two; Welch windows of 16 periods. Thread: OFF.
HarmonicError harmonic_error(const std::vector<double>& a, const std::vector<double>& b, int P, int highest);

/// Energies of every channel's first three subbands, of which `y` has one channel a sideband: 1/4...1/2 and
/// 1/8...1/4 of f0 from the harmonic, and 1/8 of it, by the spectrum. P each, channel 2k - 1 below harmonic
/// k, 2k above it. Thread: OFF.
using SubbandEnergies = std::array<std::vector<double>, 3>;
SubbandEnergies subband_energies(const std::vector<double>& y, int P);

}  // namespace rigsound::analysis
