// How bright the clicks of a bank are, and how loud once they are made duller or brighter.
#pragma once

#include <array>

#include "rigsound/click_bank.hpp"

namespace rigsound::drill {

class ClickSpectrum {
 public:
  explicit ClickSpectrum(const ClickBank& bank);  ///< Thread: OFF

  /// Slope of the levels of third octaves from 160 Hz to 8 kHz, least squares, dB an octave. Thread: OFF.
  double tilt_db_per_octave() const;

  /// Natural logarithm of the L2 norm that a tilt leaves of a click of norm 1. Thread: OFF.
  double ln_norm(double tilt_db_per_octave) const;

 private:
  static constexpr int kBands = 25;  ///< third octaves from 63 Hz
  static double centre_hz(int band);

  std::array<double, kBands> power_{};
};

}  // namespace rigsound::drill
