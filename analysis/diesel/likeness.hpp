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

/// Levels, dB, of bands of 1/`fraction` octave centred from `lowest_hz` to below `highest_hz`; none below one
/// and a half cycles. Thread: OFF.
std::vector<double> fractional_octaves(const CyclicSound& s, int fraction, double lowest_hz,
                                       double highest_hz);

/// Mean over groups of `group` neighbouring levels of the highest less the lowest, dB; a last group that is
/// not full does not count. Thread: OFF.
double valley_depth(const std::vector<double>& levels_db, std::size_t group);

/// Orders between `lowest_hz` and `highest_hz` that stand 10 dB or more above what lies midway between them.
struct StandingOrders {
  int count = 0;       ///< in the reference
  double lost_db = 0;  ///< mean by which they stand lower in the other sound
};
StandingOrders standing_orders(const CyclicSound& a, const CyclicSound& reference, double lowest_hz,
                               double highest_hz);

/// Mean power over the cycle in kEnvelopeSlots parts, mean 1, of the band low...high Hz. Thread: OFF.
constexpr int kEnvelopeSlots = 64;
std::vector<double> cyclic_envelope(const CyclicSound& s, double low_hz, double high_hz);

/// Octave bands between 100 Hz and `highest_hz` in which envelopes are compared.
std::vector<double> envelope_bands(double highest_hz);

}  // namespace rigsound::analysis
