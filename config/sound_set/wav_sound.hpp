// Opening the mono WAV files of a sound set.
#pragma once

#include <sndfile.h>

#include <filesystem>
#include <memory>

namespace rigsound::config {

using WavSound = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

/// A new mono float WAV, reproducible byte for byte. Errors: DeviceError.
WavSound create_wav(const std::filesystem::path& file, int sample_rate);

/// `format` is filled in. Errors: InputError for a file that is missing, cut off or not mono.
WavSound open_wav(const std::filesystem::path& file, SF_INFO& format);

/// Writes all samples. Errors: DeviceError naming `file`.
void write_samples(const WavSound& sound, const std::filesystem::path& file, const float* samples,
                   std::size_t count);

}  // namespace rigsound::config
