// third_octave_levels() of many sounds.
#pragma once

#include <vector>

#include "bank/third_octave.hpp"
#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {

/// One window and transform for all: to make them takes as long as a sound of a second. Thread: OFF, one at a
/// time.
class ThirdOctaveMeter {
 public:
  ThirdOctaveMeter();
  /// Of `size` samples.
  BandLevels operator()(const float* x, long size);

 private:
  std::vector<float> window_;
  FramePair pair_;
};

}  // namespace rigsound::analysis
