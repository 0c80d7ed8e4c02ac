// How loud a blow is, band by band and moment by moment: what the fit compares.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// Third-octave bands from 125 Hz up.
struct BandPicture {
  std::vector<double> centre_hz;
  std::vector<double> level_db;               ///< energy of the whole blow
  std::vector<std::vector<double>> decay_db;  ///< per band, energy within successive stretches
};

/// Ends of the stretches after the onset, s; the last ones only where the sound is that long.
constexpr double kStretch_s[] = {0.006, 0.012, 0.020, 0.032, 0.050, 0.080, 0.130, 0.200, 0.320, 0.500};

/// Of a sound at kAnalysisRate that begins kBeforeBlow samples before its onset; bands up to `highest_hz`.
/// Thread: OFF.
BandPicture band_picture(const std::vector<double>& sound, double highest_hz);

}  // namespace rigsound::analysis
