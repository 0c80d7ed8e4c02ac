// Sound as a file: on disk, whole or not at all, or in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {

/// Writes `mono` (full scale = 1, may exceed it) at `rate` Hz, atomically: as 32-bit float WAV, or as FLAC or
/// Ogg when the name ends so (audio::SoundWriter). Returns how many samples were clipped for that. Errors:
/// DeviceError when the file cannot be written. Thread: OFF.
std::uint64_t write_wave(const std::filesystem::path& path, const std::vector<float>& mono, int rate);
std::uint64_t write_wave(const std::filesystem::path& path, const std::vector<double>& mono, int rate);

/// The same under the temporary name of `file`: files that belong together are committed together.
std::uint64_t write_wave(const AtomicFile& file, const std::vector<float>& mono, int rate);

/// The bytes of a WAV file of `mono`, 32-bit float, which may exceed full scale. Thread: any.
std::string wave_bytes(const std::vector<float>& mono, int rate);

}  // namespace rigsound::analysis
