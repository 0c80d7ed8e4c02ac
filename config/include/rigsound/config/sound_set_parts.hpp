// Everything that a sound set holds, as it is stored: what a folder, a packed file and a verb that edits sets
// agree on.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/progress.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound::config {

/// What the index names, each once, at the rate it was made at.
struct SoundSetParts {
  SoundSetIndex index;
  std::vector<StoredBank> banks;     ///< by name, in the order the index first names them
  std::vector<ToolModel> tools;      ///< as the index lists bars
  std::vector<StringModel> strings;  ///< as it lists drill strings
  std::vector<DieselModel> diesels;  ///< as it lists backgrounds
};

/// Reads SET/soundset.toml and all that it names. Errors: InputError. Thread: OFF.
SoundSetParts load_parts(const std::filesystem::path& sound_set, const Progress& progress = {});

/// Writes a new sound set folder; `folder` must not be there yet. Errors: InputError, DeviceError. Thread:
/// OFF.
void save_parts(const std::filesystem::path& folder, const SoundSetParts& parts,
                const Progress& progress = {});

/// Errors: InputError naming `file` when no bank serves one of the five situations. Thread: OFF.
void require_every_situation(const SoundSetIndex& index, const std::string& file);

/// As the engine wants it: uses of banks, each bank at `sample_rate` (Hz) with its trim. Thread: OFF.
SoundSet sound_set_of(SoundSetParts parts, double sample_rate);

}  // namespace rigsound::config
