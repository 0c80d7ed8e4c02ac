// Writing sound to disk, whole or not at all.
#pragma once

#include <filesystem>
#include <vector>

namespace rigsound::analysis {

/// Writes `mono` (full scale = 1, may exceed it) as a 32-bit float WAV of `rate` Hz, atomically.
/// Errors: DeviceError when the file cannot be written. Thread: OFF.
void write_wave(const std::filesystem::path& path, const std::vector<float>& mono, int rate);
void write_wave(const std::filesystem::path& path, const std::vector<double>& mono, int rate);

}  // namespace rigsound::analysis
