// A sound set as a rig names it: a folder, or a packed file.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/config/sound_set_parts.hpp"

namespace rigsound::config {

/// Errors: InputError. Thread: OFF.
SoundSetParts load_sound_set(const std::filesystem::path& sound_set);

/// The files and folders that it is read from and written to, whether they are there or not. An empty path
/// has none. Thread: OFF.
std::vector<std::filesystem::path> content_of(const std::filesystem::path& sound_set);

}  // namespace rigsound::config
