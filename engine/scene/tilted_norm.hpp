// How much of a bank's level is left when its clicks are made duller or brighter.
#pragma once

#include <array>

#include "drill/click_spectrum.hpp"

namespace rigsound::scene {

constexpr double kLargestTilt = 9;  ///< dB an octave, either way

class TiltedNorm {
 public:
  TiltedNorm() = default;                                   ///< keeps it all
  explicit TiltedNorm(const drill::ClickSpectrum& clicks);  ///< Thread: OFF

  /// Natural logarithm of what is left of a click's L2 norm, `tilt` within +-kLargestTilt. Thread: RT.
  double ln(double tilt_db_per_octave) const noexcept;

 private:
  static constexpr int kSteps = 36;
  std::array<double, kSteps + 1> ln_{};  ///< from -kLargestTilt to kLargestTilt
};

}  // namespace rigsound::scene
