// The picture of a render: what the machine did, and what was heard of it.
#pragma once

#include <filesystem>
#include <string>

#include "rigsound/options.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

enum class TimelineTheme { kLight, kDark };

struct TimelineOptions {
  SceneOptions scene;  ///< thresholds of the feed pressure
  std::string title;   ///< empty: the name of the sound file
  TimelineTheme theme = TimelineTheme::kLight;
  int width = 1600, height = 1000;  ///< pixels, kMinTimelineWidth and kMinTimelineHeight at least
};

constexpr int kMinTimelineWidth = 640, kMinTimelineHeight = 480, kMaxTimelineSide = 10000;

/// Writes a PNG of one axis of time, that of the sound: the situation of each boom as coloured and named
/// spans, feed pressure with the thresholds, r/min of the diesel and whatever else of timeline.cpp's table
/// `states` holds; below them waveform and spectrogram of all channels together. `sound`: any file libsndfile
/// reads. `states`: CSV time_s,signal,value as `rigsound decode` prints it. The file is whole or absent.
/// Errors: InputError with file and line when an input cannot be used or is `picture` itself, DeviceError.
/// Thread: OFF.
void write_timeline(const std::filesystem::path& picture, const std::filesystem::path& sound,
                    const std::filesystem::path& states, const TimelineOptions& options,
                    const Progress& progress = {});

}  // namespace rigsound::analysis
