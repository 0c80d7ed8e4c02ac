// The mono WAV files of a sound set.
#pragma once

#include <sndfile.h>

#include <filesystem>
#include <memory>

#include "rigsound/audio/sound_memory.hpp"

namespace rigsound::config {

using WavSound = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

/// A new mono float WAV, reproducible byte for byte. Errors: DeviceError.
WavSound create_wav(const std::filesystem::path& file, int sample_rate);

/// Writes all samples. Errors: DeviceError naming `file`.
void write_samples(const WavSound& sound, const std::filesystem::path& file, const float* samples,
                   std::size_t count);

/// A WAV that was read whole: libsndfile asks the system for each number of a header by itself.
class WavReader {
 public:
  /// Errors: InputError for a file that is missing, cut off or not mono.
  explicit WavReader(const std::filesystem::path& file);
  WavReader(const WavReader&) = delete;
  WavReader& operator=(const WavReader&) = delete;

  const SF_INFO& format() const noexcept { return format_; }
  SNDFILE* get() const noexcept { return sound_.get(); }

  /// `count` samples from `first` on into `samples`. Errors: InputError when there are fewer.
  void read(sf_count_t first, sf_count_t count, float* samples) const;

 private:
  std::string name_;
  audio::SoundMemory memory_;
  SF_INFO format_{};
  WavSound sound_;
};

}  // namespace rigsound::config
