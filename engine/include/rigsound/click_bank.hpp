// The clicks of one analysed recording and the statistics that space and weigh them.
#pragma once

#include <string>
#include <vector>

namespace rigsound {

/// Where a strike is missing the gap is this many times as long; a double strike comes after this share of
/// one.
constexpr double kMissGap = 2, kDoubleGap = 0.45;

/// Result of the drilling paper's analysis (section 3), errata corrected. Times are in samples at
/// `sample_rate`, amplitudes are L2 norms in the recording's units (full scale = 1).
struct ClickBank {
  std::string name;
  double sample_rate = 48000;

  double mean_gap_samples = 0;       ///< T_0: mean gap between clicks, samples (section 3.7)
  double gap_deviation_samples = 0;  ///< sigma_T: its standard deviation, samples
  double gap_correlation = 0;        ///< lag-1 correlation of the gaps, -0.9...0.9
  double miss_share = 0;             ///< share of gaps in which a strike is missing (kMissGap)
  double double_share = 0;           ///< share of gaps cut short by a double strike (kDoubleGap)

  double mean_amplitude = 1;         ///< B: mean L2 norm of the clicks
  double amplitude_deviation = 0;    ///< sigma_B: its standard deviation
  double amplitude_correlation = 0;  ///< lag-1 correlation of the amplitudes, -0.9...0.9

  double attack_samples = 0;  ///< N_a: attack, samples (eq. 5)
  double attack_bend = 0;     ///< alpha_a: attack bend, 1/sample (eq. 5)
  double decay = 0;           ///< alpha_d: decay, 1/sample (eq. 6)

  double gain_db = 0;  ///< trim of this bank against the others, dB

  std::vector<std::vector<float>> clicks;  ///< each of unit L2 norm, at `sample_rate`
};

}  // namespace rigsound
