// Recordings as the analysis sees them: one channel at 48 kHz.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/analysis/samples.hpp"

namespace rigsound::analysis {

/// What is known of a recording beside its sound.
struct RecordingFacts {
  int source_rate = 0;      ///< Hz, of the file
  int source_channels = 0;  ///< of the file; more than one were averaged into `mono`
  long source_frames = 0;   ///< samples read, at the file's own rate
  bool silent = false;      ///< holds no sound at all, a constant offset at most
  double clipped = 0;       ///< share of them on flat tops, 0...1
  std::string fault;        ///< of the file, which was read all the same; empty: none
};

struct Recording : RecordingFacts {
  std::vector<float> mono;  ///< samples at kAnalysisRate, full scale 1
};

/// A recording of any length.
struct LongRecording : RecordingFacts {
  Samples mono;  ///< as above
};

constexpr int kMinSourceRate = 16000;  ///< Hz; below it the clicks' bandwidth is not there
constexpr double kMinRecordingSeconds = 0.25;

/// A piece of a recording; what lies behind its end is not there.
struct Stretch {
  double start_s = 0, end_s = std::numeric_limits<double>::infinity();
};

/// Reads a stretch of any file libsndfile reads (`-`: standard input), averages its channels and resamples it
/// to kAnalysisRate. Errors: InputError when the file is missing, unreadable, or lies outside the ranges
/// above, or the stretch is empty, too short, silent, or holds a sample that is not finite. `subject`: what a
/// silent one lacks. Thread: OFF.
Recording read_recording(const std::filesystem::path& path, const Stretch& stretch = {},
                         std::string_view subject = "drilling");

/// Which stretch of a recording of so many seconds is read.
using ChooseStretch = std::function<Stretch(double recording_s)>;

/// The same of a stretch that depends on how long the recording is. Thread: OFF.
Recording read_recording(const std::filesystem::path& path, const ChooseStretch& choose,
                         std::string_view subject);

/// The same, its sound kept in `file`: memory does not grow with its length. Thread: OFF.
LongRecording read_long_recording(const std::filesystem::path& path, const Stretch& stretch,
                                  SampleFile& file);

/// The whole file, as the first, but a silent one is no error. Thread: OFF.
Recording read_recording_or_silence(const std::filesystem::path& path);

/// What people should know of how it was read, a line each: "FILE: 6 channels mixed down to one", a fault of
/// the file. Thread: OFF.
std::vector<std::string> reading_notes(const std::filesystem::path& path, const RecordingFacts& recording);

/// Whether a file's ending says that it is a recording; hidden files are none. Thread: any.
bool is_recording_name(const std::filesystem::path& file);

/// Length of the file. Errors: InputError as above. Thread: OFF.
double recording_seconds(const std::filesystem::path& path);

/// `x` at kAnalysisRate, as long as `recording.mono`, brought to the rate and length of the file. Thread:
/// OFF.
std::vector<float> at_source_rate(const Recording& recording, const std::vector<float>& x);

}  // namespace rigsound::analysis
