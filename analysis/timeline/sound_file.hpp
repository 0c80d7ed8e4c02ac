// A sound file as a picture shows it: at its own rate, all channels together.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/progress.hpp"

namespace rigsound::analysis {

struct SoundFile {
  std::vector<float> mono;  ///< mean of the channels, full scale 1
  int rate = 0;             ///< Hz
  int channels = 0;
  double peak = 0;  ///< largest magnitude in any channel
  double seconds() const { return static_cast<double>(mono.size()) / rate; }
};

/// Errors: InputError when libsndfile cannot read it, it holds no sample or one that is not finite. Thread:
/// OFF.
SoundFile read_sound(const std::filesystem::path& file, const Progress& progress = {});

}  // namespace rigsound::analysis
