#include "rigsound/analysis/recording.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "recording/resample.hpp"
#include "rigsound/analysis/chain.hpp"
#include "rigsound/input_error.hpp"

namespace rigsound::analysis {
namespace {

using Sound = std::unique_ptr<SNDFILE, decltype(&sf_close)>;

Sound open(const std::filesystem::path& path, SF_INFO& info) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    throw InputError(path.string(), "no such file, expected a recording");
  if (std::filesystem::is_directory(path, none))
    throw InputError(path.string(), "is a folder, expected a recording");
  Sound sound(sf_open(path.c_str(), SFM_READ, &info), &sf_close);
  if (!sound)
    throw InputError(path.string(),
                     fmt::format("not a sound file ({}), expected WAV, FLAC or another format of libsndfile",
                                 sf_strerror(nullptr)));
  return sound;
}

void check_format(const std::filesystem::path& path, const SF_INFO& info) {
  const std::string file = path.string();
  if (info.channels > kMaxSourceChannels)
    throw InputError(file, fmt::format("{} channels, expected 1 to {}", info.channels, kMaxSourceChannels));
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

std::vector<float> read_mixed_down(SNDFILE* sound, const SF_INFO& info) {
  const int channels = info.channels;
  std::vector<float> frames(static_cast<size_t>(info.frames) * channels);
  const sf_count_t got = sf_readf_float(sound, frames.data(), info.frames);
  std::vector<float> mono(static_cast<size_t>(std::max<sf_count_t>(got, 0)));
  for (size_t n = 0; n < mono.size(); ++n) {
    float sum = 0;
    for (int c = 0; c < channels; ++c) sum += frames[n * channels + c];
    mono[n] = sum / static_cast<float>(channels);
  }
  return mono;
}

void check_samples(const std::filesystem::path& path, const std::vector<float>& mono, int rate) {
  const auto bad = std::find_if(mono.begin(), mono.end(), [](float x) { return !std::isfinite(x); });
  if (bad != mono.end())
    throw InputError(path.string(),
                     fmt::format("sample {} ({:.3f} s) is not a number, expected finite samples",
                                 bad - mono.begin(), static_cast<double>(bad - mono.begin()) / rate));
  const auto [low, high] = std::minmax_element(mono.begin(), mono.end());
  if (*high - *low < 1e-6f)
    throw InputError(path.string(), "silent, no drilling found; expected a recording of drilling");
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  SF_INFO info{};
  const Sound sound = open(path, info);
  check_format(path, info);
  const std::vector<float> mono = read_mixed_down(sound.get(), info);
  if (static_cast<double>(mono.size()) < kMinRecordingSeconds * info.samplerate)
    throw InputError(path.string(), fmt::format("cut off after {} of {} frames, expected the whole file",
                                                mono.size(), info.frames));
  check_samples(path, mono, info.samplerate);
  return {resample(mono, info.samplerate, static_cast<int>(kAnalysisRate)), info.samplerate, info.channels,
          static_cast<long>(mono.size())};
}

std::vector<float> at_source_rate(const Recording& recording, const std::vector<float>& x) {
  std::vector<float> y = resample(x, static_cast<int>(kAnalysisRate), recording.source_rate);
  y.resize(static_cast<size_t>(recording.source_frames));
  return y;
}

}  // namespace rigsound::analysis
