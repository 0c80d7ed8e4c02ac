// A sound set as a rig names it: a folder, or a packed file.
#pragma once

#include <filesystem>

#include "rigsound/config/sound_set_parts.hpp"

namespace rigsound::config {

/// Errors: InputError. Thread: OFF.
SoundSetParts load_sound_set(const std::filesystem::path& sound_set);

}  // namespace rigsound::config
