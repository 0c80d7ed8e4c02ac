// How loud an impact is, band by band and moment by moment: what the fit compares.
#pragma once

#include <unsupported/Eigen/FFT>
#include <vector>

namespace rigsound::analysis {

/// Third-octave bands from 125 Hz up.
struct BandProfile {
  std::vector<double> level_db;               ///< energy of the whole impact
  std::vector<std::vector<double>> decay_db;  ///< per band, energy within successive stretches
};

/// Ends of the stretches after the onset, s; the last ones only where the sound is that long.
constexpr double kStretch_s[] = {0.006, 0.012, 0.020, 0.032, 0.050, 0.080, 0.130, 0.200, 0.320, 0.500};

/// Band levels and decays of the sounds of one fit; made once, because its tables cost as much as one
/// analysis. Thread: OFF.
class BandAnalyser {
 public:
  /// For bands up to `highest_hz`.
  explicit BandAnalyser(double highest_hz);

  const std::vector<double>& centre_hz() const { return centre_hz_; }

  /// Of a sound at kAnalysisRate that begins kBeforeImpact samples before its onset.
  BandProfile analyse(const std::vector<double>& sound);

 private:
  std::vector<double> power_spectrum(const std::vector<double>& x);
  void add_decays(const std::vector<double>& sound, BandProfile& profile);

  std::vector<double> centre_hz_, window_;
  Eigen::FFT<double> fft_;
};

}  // namespace rigsound::analysis
