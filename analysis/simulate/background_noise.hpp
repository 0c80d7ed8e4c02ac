// The simulated rig around the drill: diesel orders, hydraulic noise, pump whine, a noise floor.
#pragma once

#include <vector>

#include "simulate/split_mix.hpp"

namespace rigsound::analysis {

/// Speed of the diesel. One cycle is 720 degrees of crank angle.
struct BackgroundScene {
  std::vector<double> cycles_hz;  ///< cycles a second at every sample: cycles_per_second() of its r/min

  /// A wandering speed, 12-18 cycles/s, drawn from `stream`.
  static BackgroundScene drawn(double seconds, SplitMix& stream);
  /// A speed that changes linearly from one r/min to another, with a slow wander of 1 %.
  static BackgroundScene ramp(double seconds, double rpm_start, double rpm_end);
};

/// RMS 1. `structure` draws the diesel (phases, order levels, filters), `noise` the samples of the noises.
std::vector<double> background_noise(const BackgroundScene& scene, SplitMix& structure, SplitMix& noise);

}  // namespace rigsound::analysis
