// Writing sound to disk, whole or not at all.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {

/// Writes `mono` (full scale = 1, may exceed it) as a 32-bit float WAV of `rate` Hz, atomically.
/// Errors: DeviceError when the file cannot be written. Thread: OFF.
void write_wave(const std::filesystem::path& path, const std::vector<float>& mono, int rate);
void write_wave(const std::filesystem::path& path, const std::vector<double>& mono, int rate);

/// The same under the temporary name of `file`: files that belong together are committed together.
void write_wave(const AtomicFile& file, const std::vector<float>& mono, int rate);

}  // namespace rigsound::analysis
