// WAV files whose chunks do not say where the samples lie, as players read them all the same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rigsound::analysis {

/// A header that libsndfile understands, and the bytes of the file that belong behind it.
struct WaveRepair {
  std::string header;               ///< RIFF, fmt and data chunk, up to the first sample
  std::int64_t begin = 0, end = 0;  ///< the samples, bytes of the file
  std::string fault;                ///< what was wrong, for people
};

/// What reads a WAV whose data chunk has size 0 though samples follow (streamed, or the recorder lost power),
/// or that has a chunk of odd length without its pad byte before the samples. None when the file is no WAV or
/// needs no repair. Thread: OFF.
std::optional<WaveRepair> wave_repair(const std::filesystem::path& path);

}  // namespace rigsound::analysis
