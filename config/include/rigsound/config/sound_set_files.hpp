// A sound set folder as the engine wants it.
#pragma once

#include <filesystem>

#include "rigsound/sound_set.hpp"

namespace rigsound::config {

/// Reads SET/soundset.toml and all that it names. Banks recorded at another rate are resampled to
/// `sample_rate` (Hz). The order of uses, rocks, tools and backgrounds is that of soundset.toml.
/// Errors: InputError. Thread: OFF.
SoundSet load_sound_set(const std::filesystem::path& sound_set, double sample_rate);

}  // namespace rigsound::config
