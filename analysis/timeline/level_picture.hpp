// A spectrogram in decibels, pixel by pixel.
#pragma once

#include "chart/canvas.hpp"
#include "timeline/sound_file.hpp"

namespace rigsound::analysis {

constexpr double kLevelRange_db = 80;
constexpr double kLowestLevel_hz = 40;

struct LevelPicture {
  chart::Picture picture;  ///< its palette spans kLevelRange_db
  double top_db;           ///< of its last colour; a sine of full scale has 0 dB
  double highest_hz;       ///< upper edge; frequency is logarithmic from kLowestLevel_hz
};

/// Power of a Hann window of 4096 samples, averaged over each pixel. Thread: OFF.
LevelPicture level_picture(const SoundFile& sound, int width, int height);

}  // namespace rigsound::analysis
