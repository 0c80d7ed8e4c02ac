#include "rigsound/analysis/recording.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "recording/clipping.hpp"
#include "recording/mean_channel.hpp"
#include "recording/open_sound.hpp"
#include "recording/resample.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

/// What to read the recording from, a pipe too.
InputFile input_of(const std::filesystem::path& path) {
  std::error_code none;
  if (path != "-" && !std::filesystem::exists(path, none))
    throw InputError(path.string(), "no such file, expected a recording");
  return {path, "recording"};
}

void require_sound(const OpenSound& sound, const InputFile& input) {
  if (!sound.get())
    throw InputError(input.name(),
                     fmt::format("not a sound file ({}), expected WAV, FLAC or another format of libsndfile",
                                 sf_strerror(nullptr)));
}

void check_format(const std::string& file, const SF_INFO& info) {
  if (info.samplerate < kMinSourceRate)
    throw InputError(
        file, fmt::format("sample rate {} Hz, expected {} Hz or more", info.samplerate, kMinSourceRate));
  if (info.frames <= 0)
    throw InputError(file, fmt::format("holds no samples, expected {} s or more", kMinRecordingSeconds));
  const double seconds = static_cast<double>(info.frames) / info.samplerate;
  if (seconds < kMinRecordingSeconds)
    throw InputError(file,
                     fmt::format("{:.3f} s long, expected {} s or more", seconds, kMinRecordingSeconds));
}

/// Frames of the file, from `begin` up to `end`.
struct Frames {
  sf_count_t begin, end;
};

Frames frames_of(const Stretch& stretch, const SF_INFO& info) {
  const auto frame = [&](double s) {
    return std::llround(std::min(s * info.samplerate, static_cast<double>(info.frames)));
  };
  return {frame(stretch.start_s), frame(stretch.end_s)};
}

/// What is there of a stretch.
std::vector<float> read_mixed_down(SNDFILE* sound, int channels, const Frames& frames) {
  std::vector<float> mono;
  if (sf_seek(sound, frames.begin, SEEK_SET) != frames.begin) return mono;
  mono.resize(static_cast<size_t>(frames.end - frames.begin));
  mono.resize(read_mean(sound, channels, mono.data(), mono.size()));
  return mono;
}

void check_samples(const std::string& file, const std::vector<float>& mono, sf_count_t begin, int rate) {
  const auto bad = std::find_if(mono.begin(), mono.end(), [](float x) { return !std::isfinite(x); });
  if (bad != mono.end()) {
    const auto at = begin + (bad - mono.begin());
    throw InputError(file, fmt::format("sample {} ({:.3f} s) is not a number, expected finite samples", at,
                                       static_cast<double>(at) / rate));
  }
}

bool is_silent(const std::vector<float>& mono) {
  const auto [low, high] = std::minmax_element(mono.begin(), mono.end());
  return *high - *low < 1e-6f;
}

Recording read_stretch(const std::filesystem::path& path, const Stretch& stretch) {
  SF_INFO info{};
  const InputFile input = input_of(path);
  const OpenSound sound(input.path(), info);
  require_sound(sound, input);
  check_format(input.name(), info);
  const Frames frames = frames_of(stretch, info);
  const double seconds = static_cast<double>(frames.end - frames.begin) / info.samplerate;
  if (seconds < kMinRecordingSeconds)
    throw InputError(input.name(),
                     fmt::format("the stretch from {:.3f} s is {:.3f} s long, expected {} s or more",
                                 stretch.start_s, std::max(seconds, 0.0), kMinRecordingSeconds));
  const std::vector<float> mono = read_mixed_down(sound.get(), info.channels, frames);
  if (static_cast<double>(mono.size()) < kMinRecordingSeconds * info.samplerate)
    throw InputError(input.name(),
                     fmt::format("cut off after {} of {} frames, expected the whole file",
                                 frames.begin + static_cast<sf_count_t>(mono.size()), info.frames));
  check_samples(input.name(), mono, frames.begin, info.samplerate);
  return {resample(mono, info.samplerate, static_cast<int>(kAnalysisRate)),
          info.samplerate,
          info.channels,
          static_cast<long>(mono.size()),
          is_silent(mono),
          clipped_share(mono),
          sound.fault()};
}

}  // namespace

bool is_recording_name(const std::filesystem::path& file) {
  static const std::set<std::string> kExtensions = {".wav", ".wave", ".w64",  ".rf64", ".flac",
                                                    ".aif", ".aiff", ".aifc", ".au",   ".snd",
                                                    ".caf", ".ogg",  ".oga",  ".opus", ".mp3"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kExtensions.count(extension) > 0 && file.filename().string()[0] != '.';
}

Recording read_recording(const std::filesystem::path& path, const Stretch& stretch,
                         std::string_view subject) {
  Recording recording = read_stretch(path, stretch);
  if (recording.silent)
    throw InputError(path.string(), fmt::format("silent, no {} found in it; expected to hear some", subject));
  return recording;
}

Recording read_recording_or_silence(const std::filesystem::path& path) { return read_stretch(path, {}); }

std::vector<std::string> reading_notes(const std::filesystem::path& path, const Recording& recording) {
  std::vector<std::string> notes;
  if (!recording.fault.empty()) notes.push_back(fmt::format("{}: {}", path.string(), recording.fault));
  if (recording.source_channels > 1)
    notes.push_back(
        fmt::format("{}: {} channels mixed down to one", path.string(), recording.source_channels));
  return notes;
}

double recording_seconds(const std::filesystem::path& path) {
  SF_INFO info{};
  const InputFile input = input_of(path);
  const OpenSound sound(input.path(), info);
  require_sound(sound, input);
  check_format(input.name(), info);
  return static_cast<double>(info.frames) / info.samplerate;
}

std::vector<float> at_source_rate(const Recording& recording, const std::vector<float>& x) {
  std::vector<float> y = resample(x, static_cast<int>(kAnalysisRate), recording.source_rate);
  y.resize(static_cast<size_t>(recording.source_frames));
  return y;
}

}  // namespace rigsound::analysis
