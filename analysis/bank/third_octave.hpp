// Long-time average spectrum in third-octave bands, and the modulation spectrum of the envelope.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

struct BandLevels {
  std::vector<double> centre_hz;
  std::vector<double> level_db;
};

constexpr int kThirdOctaveFrame = 8192;  ///< samples

/// 62.5 Hz...16 kHz at 48 kHz; Hann frames, half overlapping; the mean square in each band, dB re full-scale
/// square. Thread: OFF.
BandLevels third_octave_levels(const std::vector<float>& x);

/// What that tends to of a long sound, from its power spectrum: the transform of its autocorrelation, half of
/// a power of two of points and one, of kThirdOctaveFrame at least. Thread: OFF.
BandLevels third_octave_levels_of(const Eigen::ArrayXd& power);

/// Envelope (RMS of 1 ms, over its mean) in third-octave bands of modulation frequency, 1...256 Hz, dB.
/// Thread: OFF.
BandLevels modulation_levels(const std::vector<float>& x);

/// Sum of the bands' powers. Thread: OFF.
double power(const BandLevels& levels);

/// Mean |a - b| in dB over the bands within `range_db` of the loudest of `a`; `centred` levels first lose
/// their mean difference there. Thread: OFF.
enum class Difference { kAbsolute, kCentred };
double mean_difference_db(const BandLevels& a, const BandLevels& b, double range_db, Difference difference);

}  // namespace rigsound::analysis
