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

  double T_0 = 0;       ///< mean gap between clicks, samples (section 3.7)
  double sigma_T = 0;   ///< its standard deviation, samples
  double r_T = 0;       ///< lag-1 correlation of the gaps, -0.9...0.9
  double p_miss = 0;    ///< share of gaps in which a strike is missing (kMissGap)
  double p_double = 0;  ///< share of gaps cut short by a double strike (kDoubleGap)

  double B = 1;        ///< mean L2 norm of the clicks
  double sigma_B = 0;  ///< its standard deviation
  double r_B = 0;      ///< lag-1 correlation of the amplitudes, -0.9...0.9

  double N_a = 0;      ///< attack, samples (eq. 5)
  double alpha_a = 0;  ///< attack bend, 1/sample (eq. 5)
  double alpha_d = 0;  ///< decay, 1/sample (eq. 6)

  double gain_db = 0;  ///< trim of this bank against the others, dB

  std::vector<std::vector<float>> clicks;  ///< each of unit L2 norm, at `sample_rate`
};

}  // namespace rigsound
