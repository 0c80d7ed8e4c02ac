#include "rigsound/analysis/recording.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "recording/clipping.hpp"
#include "recording/mean_channel.hpp"
#include "recording/open_sound.hpp"
#include "recording/resample.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/file/ending.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kReadRate = static_cast<int>(kAnalysisRate);

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

using PieceListener = std::function<void(const std::vector<float>& piece)>;

/// Hands out the frames, mixed down, piece by piece: a long recording is never in memory. Returns how many
/// there were.
sf_count_t read_mixed_down(SNDFILE* sound, int channels, const Frames& frames,
                           const PieceListener& listener) {
  constexpr std::size_t kPiece = 1 << 14;
  if (sf_seek(sound, frames.begin, SEEK_SET) != frames.begin) return 0;
  std::vector<float> mono;
  sf_count_t left = frames.end - frames.begin;
  while (left > 0) {
    mono.resize(std::min(kPiece, static_cast<std::size_t>(left)));
    mono.resize(read_mean(sound, channels, mono.data(), mono.size()));
    if (mono.empty()) break;
    listener(mono);
    left -= static_cast<sf_count_t>(mono.size());
  }
  return frames.end - frames.begin - left;
}

void check_samples(const std::string& file, const std::vector<float>& mono, sf_count_t begin, int rate) {
  const auto bad = std::find_if(mono.begin(), mono.end(), [](float x) { return !std::isfinite(x); });
  if (bad != mono.end()) {
    const auto at = begin + (bad - mono.begin());
    throw InputError(file, fmt::format("sample {} ({:.3f} s) is not a number, expected finite samples", at,
                                       static_cast<double>(at) / rate));
  }
}

/// Lowest and highest sample.
struct Extent {
  float low = std::numeric_limits<float>::infinity(), high = -low;

  void add(const std::vector<float>& piece) {
    for (const float v : piece) low = std::min(low, v), high = std::max(high, v);
  }
  bool silent() const { return high - low < 1e-6f; }
  float peak() const { return std::max(-low, high); }
};

/// A stretch of a recording that is there, reads twice: once to be judged, once to be heard.
class StretchReader {
 public:
  StretchReader(const std::filesystem::path& path, const ChooseStretch& choose)
      : input_(input_of(path)), sound_(input_.path(), info_) {
    require_sound(sound_, input_);
    check_format(input_.name(), info_);
    const Stretch stretch = choose(static_cast<double>(info_.frames) / info_.samplerate);
    frames_ = frames_of(stretch, info_);
    const double seconds = static_cast<double>(frames_.end - frames_.begin) / info_.samplerate;
    if (seconds < kMinRecordingSeconds)
      throw InputError(input_.name(),
                       fmt::format("the stretch from {:.3f} s is {:.3f} s long, expected {} s or more",
                                   stretch.start_s, std::max(seconds, 0.0), kMinRecordingSeconds));
    survey();
  }

  bool silent() const { return extent_.silent(); }
  size_t length() const {
    return resampled_length(static_cast<size_t>(samples_), info_.samplerate, kReadRate);
  }

  /// Hands out the sound at kAnalysisRate.
  RecordingFacts read(const PieceListener& listener) {
    FlatTops tops(extent_.peak());
    Resampler resampler(info_.samplerate, kReadRate, static_cast<size_t>(samples_));
    each([&](const std::vector<float>& piece) {
      tops.add(piece);
      listener(resampler.process(piece));
    });
    listener(resampler.finish());
    return {info_.samplerate, info_.channels, static_cast<long>(samples_),
            silent(),         tops.share(),   sound_.fault()};
  }

 private:
  sf_count_t each(const PieceListener& listener) {
    return read_mixed_down(sound_.get(), info_.channels, frames_, listener);
  }

  void survey() {
    sf_count_t begin = frames_.begin;
    samples_ = each([&](const std::vector<float>& piece) {
      check_samples(input_.name(), piece, begin, info_.samplerate);
      extent_.add(piece);
      begin += static_cast<sf_count_t>(piece.size());
    });
    if (static_cast<double>(samples_) < kMinRecordingSeconds * info_.samplerate)
      throw InputError(input_.name(), fmt::format("cut off after {} of {} frames, expected the whole file",
                                                  frames_.begin + samples_, info_.frames));
  }

  SF_INFO info_{};
  InputFile input_;
  OpenSound sound_;
  Frames frames_{};
  sf_count_t samples_ = 0;
  Extent extent_;
};

ChooseStretch just(const Stretch& stretch) {
  return [stretch](double) { return stretch; };
}

void require_heard(const StretchReader& reader, const std::filesystem::path& path, std::string_view subject) {
  if (reader.silent())
    throw InputError(path.string(), fmt::format("silent, no {} found in it; expected to hear some", subject));
}

Recording in_memory(StretchReader& reader) {
  Recording recording;
  recording.mono.reserve(reader.length());
  static_cast<RecordingFacts&>(recording) = reader.read([&](const std::vector<float>& piece) {
    recording.mono.insert(recording.mono.end(), piece.begin(), piece.end());
  });
  return recording;
}

}  // namespace

bool is_recording_name(const std::filesystem::path& file) {
  static const std::set<std::string> kExtensions = {".wav", ".wave", ".w64",  ".rf64", ".flac",
                                                    ".aif", ".aiff", ".aifc", ".au",   ".snd",
                                                    ".caf", ".ogg",  ".oga",  ".opus", ".mp3"};
  return kExtensions.count(ending_of(file)) > 0 && file.filename().string()[0] != '.';
}

Recording read_recording(const std::filesystem::path& path, const ChooseStretch& choose,
                         std::string_view subject) {
  StretchReader reader(path, choose);
  require_heard(reader, path, subject);
  return in_memory(reader);
}

Recording read_recording(const std::filesystem::path& path, const Stretch& stretch,
                         std::string_view subject) {
  return read_recording(path, just(stretch), subject);
}

LongRecording read_long_recording(const std::filesystem::path& path, const Stretch& stretch,
                                  SampleFile& file) {
  StretchReader reader(path, just(stretch));
  require_heard(reader, path, "drilling");
  LongRecording recording;
  static_cast<RecordingFacts&>(recording) =
      reader.read([&](const std::vector<float>& piece) { file.add(piece, recording.mono); });
  return recording;
}

Recording read_recording_or_silence(const std::filesystem::path& path) {
  StretchReader reader(path, just({}));
  return in_memory(reader);
}

std::vector<std::string> reading_notes(const std::filesystem::path& path, const RecordingFacts& recording) {
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
