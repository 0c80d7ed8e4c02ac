// The diesel and its hydraulics, as the background layer plays them.
#pragma once

#include <string>
#include <vector>

namespace rigsound {

/// Harmonic-plus-noise engine at one operating point. Orders count cycles of 720 degrees crank angle.
struct BackgroundModel {
  std::string name;
  double rpm = 900;                     ///< r/min at which it was learned
  std::vector<float> order_amplitude;   ///< linear peak amplitude of order k + 1, full scale = 1
  float noise_level = 0;                ///< RMS of the noise part, full scale = 1
};

}  // namespace rigsound
