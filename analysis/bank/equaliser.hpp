// Step 8: the bank filtered so that what it plays has the spectrum and level of the recording.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "bank/endless_spectrum.hpp"
#include "bank/third_octave.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// Filters all clicks of `bank` by one minimum-phase FIR (1023 taps, within 12 dB) that takes the
/// third-octave levels of endless synthesis to `target`. B and sigma_B take over the gain. `pairs`: of this
/// bank. Thread: OFF.
void equalise(ClickBank& bank, const ImpactPairs& pairs, const BandLevels& target);

/// Sets B, with sigma_B in proportion, so that endless synthesis has the mean square `power`. Thread: OFF.
void set_level(ClickBank& bank, const ImpactPairs& pairs, double power);

/// Minimum-phase FIR of `taps` samples whose gain at f (Hz, 48 kHz) is `gain_db(f)`, by folding the real
/// cepstrum of an 8192-point design. Thread: OFF.
Eigen::ArrayXd minimum_phase_fir(const std::function<double(double)>& gain_db, int taps);

}  // namespace rigsound::analysis
