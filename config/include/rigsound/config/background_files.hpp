// A diesel on disk: backgrounds/NAME/background.json.
#pragma once

#include <filesystem>

#include "rigsound/background_model.hpp"

namespace rigsound::config {

/// Writes SET/backgrounds/NAME; the folder is whole or absent. Errors: InputError, DeviceError. Thread: OFF.
void save_background(const std::filesystem::path& sound_set, const BackgroundModel& background);

/// Reads a folder SET/backgrounds/NAME, every value checked. Errors: InputError. Thread: OFF.
BackgroundModel load_background(const std::filesystem::path& folder);

}  // namespace rigsound::config
