// Recordings as the analysis sees them: one channel at 48 kHz.
#pragma once

#include <filesystem>
#include <vector>

namespace rigsound::analysis {

struct Recording {
  std::vector<float> mono;  ///< samples at kAnalysisRate, full scale 1
  int source_rate = 0;      ///< Hz, of the file
  int source_channels = 0;  ///< of the file; more than one were averaged into `mono`
  long source_frames = 0;   ///< length of the file at its own rate
};

constexpr int kMinSourceRate = 16000;  ///< Hz; below it the clicks' bandwidth is not there
constexpr int kMaxSourceChannels = 2;  ///< microphones on one drill; more is a mixing desk's file
constexpr double kMinRecordingSeconds = 0.25;

/// Reads any file libsndfile reads, averages its channels and resamples it to kAnalysisRate.
/// Errors: InputError when the file is missing, unreadable, empty, too short, silent, holds a sample
/// that is not finite, or lies outside the ranges above. Thread: OFF.
Recording read_recording(const std::filesystem::path& path);

/// `x` at kAnalysisRate, as long as `recording.mono`, brought to the rate and length of the file. Thread:
/// OFF.
std::vector<float> at_source_rate(const Recording& recording, const std::vector<float>& x);

}  // namespace rigsound::analysis
