// A diesel on disk: backgrounds/NAME/background.json, and WAV files beside it: grains_I.wav, the clean cycles
// of point I end to end (each 1.25 N_theta samples, a cue-less row of equal lengths), start.wav and stop.wav.
#pragma once

#include <filesystem>

#include "rigsound/diesel_model.hpp"

namespace rigsound::config {

/// Writes SET/backgrounds/NAME; the folder is whole or absent. Errors: InputError, DeviceError. Thread: OFF.
void save_background(const std::filesystem::path& sound_set, const DieselModel& background);

/// Reads a folder SET/backgrounds/NAME, every value and shape checked. Errors: InputError. Thread: OFF.
DieselModel load_background(const std::filesystem::path& folder);

}  // namespace rigsound::config
