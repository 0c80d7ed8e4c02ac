// How loud a blow is, band by band and moment by moment: what the fit compares.
#pragma once

#include <unsupported/Eigen/FFT>
#include <vector>

namespace rigsound::analysis {

/// Third-octave bands from 125 Hz up.
struct BandPicture {
  std::vector<double> level_db;               ///< energy of the whole blow
  std::vector<std::vector<double>> decay_db;  ///< per band, energy within successive stretches
};

/// Ends of the stretches after the onset, s; the last ones only where the sound is that long.
constexpr double kStretch_s[] = {0.006, 0.012, 0.020, 0.032, 0.050, 0.080, 0.130, 0.200, 0.320, 0.500};

/// Takes the pictures of one fit; made once, because what it prepares costs as much as a picture. Thread:
/// OFF.
class BandCamera {
 public:
  /// For bands up to `highest_hz`.
  explicit BandCamera(double highest_hz);

  const std::vector<double>& centre_hz() const { return centre_hz_; }

  /// Of a sound at kAnalysisRate that begins kBeforeBlow samples before its onset.
  BandPicture picture(const std::vector<double>& sound);

 private:
  std::vector<double> power_spectrum(const std::vector<double>& x);
  void add_decays(const std::vector<double>& sound, BandPicture& picture);

  std::vector<double> centre_hz_, window_;
  Eigen::FFT<double> fft_;
};

}  // namespace rigsound::analysis
