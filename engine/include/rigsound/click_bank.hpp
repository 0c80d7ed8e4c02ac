// The clicks of one analysed recording and the statistics that space and weigh them.
#pragma once

#include <string>
#include <vector>

#include "rigsound/click.hpp"
#include "rigsound/machine/fields.hpp"

namespace rigsound {

/// Where a strike is missing the gap is this many times as long; a double strike comes after this share of
/// one.
constexpr double kMissGap = 2, kDoubleGap = 0.45;

/// How far a click's L2 norm may be from one; the float rounding of a long click stays below.
constexpr double kUnitNormTolerance = 1e-5;

/// Result of the drilling paper's analysis (section 3), errata corrected. Times are in samples at
/// `sample_rate`, amplitudes are L2 norms in the recording's units (full scale = 1).
struct ClickBank {
  std::string name;
  double sample_rate = 48000;

  double mean_gap_samples = 0;       ///< T_0: mean gap between clicks, samples (section 3.7)
  double gap_deviation_samples = 0;  ///< sigma_T: its standard deviation, samples
  double gap_correlation = 0;        ///< lag-1 correlation of the gaps
  double miss_share = 0;             ///< share of gaps in which a strike is missing (kMissGap)
  double double_share = 0;           ///< share of gaps cut short by a double strike (kDoubleGap)

  double mean_amplitude = 1;         ///< B: mean L2 norm of the clicks
  double amplitude_deviation = 0;    ///< sigma_B: its standard deviation
  double amplitude_correlation = 0;  ///< lag-1 correlation of the amplitudes

  double attack_samples = 0;  ///< N_a: attack, samples (eq. 5)
  double attack_bend = 0;     ///< alpha_a: attack bend, 1/sample (eq. 5)
  double decay = 0;           ///< alpha_d: decay, 1/sample (eq. 6)

  double gain_db = 0;  ///< trim of this bank against the others, dB

  std::vector<Click> clicks;  ///< each of unit L2 norm, at `sample_rate`
};

/// The numbers of bank.json. Times are samples of banks of any rate.
template <class Archive>
void fields(Archive& a, ClickBank& o) {
  constexpr double kMinRate = 8000, kMaxRate = 192000;
  constexpr Range kCorrelations{-0.99, 0.99}, kShares{0, 1};
  a("sample_rate", o.sample_rate, Range{kMinRate, kMaxRate, "Hz"}.whole());
  a("T0", o.mean_gap_samples, Range{kMinRate / 200, kMaxRate, "samples"});
  a("sigma_T", o.gap_deviation_samples, Range{0, 2 * kMaxRate, "samples"});
  a("r_T", o.gap_correlation, kCorrelations);
  a("p_miss", o.miss_share, kShares);
  a("p_double", o.double_share, kShares);
  a("B", o.mean_amplitude, Range{1e-12, 1e6});
  a("sigma_B", o.amplitude_deviation, Range{0, 4e6});
  a("r_B", o.amplitude_correlation, kCorrelations);
  a("N_a", o.attack_samples, Range{0, kMaxRate, "samples"});
  a("alpha_a", o.attack_bend, Range{-100, 100, "1/sample"});
  a("alpha_d", o.decay, Range{0, 1, "1/sample"});
  a("gain_db", o.gain_db, Range{-60, 60, "dB"});
}

/// Throws InvalidField when `bank` cannot be played: a number out of its range or at odds with another, no
/// clicks, an empty click or one that is not finite. Thread: OFF.
void require_valid(const ClickBank& bank);

/// The same of all but the clicks. Thread: OFF.
void require_valid_numbers(const ClickBank& bank);

/// How bright the clicks are: slope of their mean power spectrum from 160 Hz to 8 kHz, dB an octave. Thread:
/// OFF.
double spectral_tilt(const ClickBank& bank);

}  // namespace rigsound
