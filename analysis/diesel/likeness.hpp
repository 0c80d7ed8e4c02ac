// How near one diesel sound comes to another, as numbers (README, c6).
#pragma once

#include <vector>

namespace rigsound::analysis {

/// A diesel at one speed in whole cycles, N angle samples each.
struct CyclicSound {
  std::vector<double> y;
  int N = 0;
  double f0 = 0;  ///< cycles a second
};

struct Likeness {
  double third_octave_db = 0;     ///< rms difference of third-octave levels
  double cyclic_envelope_db = 0;  ///< rms difference of the mean power over the cycle, per octave, averaged
  double modulation_db = 0;       ///< rms difference of the spectrum of the power, per octave, averaged
};

/// Both must begin at the same crank angle. `highest_hz`: nothing above counts. Thread: OFF.
Likeness likeness(const CyclicSound& a, const CyclicSound& b, double highest_hz);

/// Third-octave levels, dB, from 40 Hz up, and their centres. Thread: OFF.
struct ThirdOctaves {
  std::vector<double> centre_hz, db;
};
ThirdOctaves third_octaves(const CyclicSound& s, double highest_hz);

/// Mean power over the cycle in kEnvelopeSlots parts, mean 1, of the band low...high Hz. Thread: OFF.
constexpr int kEnvelopeSlots = 64;
std::vector<double> cyclic_envelope(const CyclicSound& s, double low_hz, double high_hz);

/// Octave bands between 100 Hz and `highest_hz` in which envelopes are compared.
std::vector<double> envelope_bands(double highest_hz);

}  // namespace rigsound::analysis
