// Mono float WAV files of a sound set.
#pragma once

#include <filesystem>
#include <vector>

namespace rigsound::config {

/// Reproducible byte for byte. Errors: DeviceError.
void write_mono_wav(const std::filesystem::path& file, const std::vector<float>& samples, int sample_rate);

struct MonoWav {
  std::vector<float> samples;
  int sample_rate = 0;
};

/// Errors: InputError for a file that is missing, not mono, or holds samples that are not finite.
MonoWav read_mono_wav(const std::filesystem::path& file);

}  // namespace rigsound::config
