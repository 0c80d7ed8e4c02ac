// background.json: a diesel in numbers people can read, levels in dB.
#pragma once

#include <filesystem>
#include <string>

#include "rigsound/diesel_model.hpp"

namespace rigsound::config {

constexpr int kBackgroundFormat = 1;

/// Everything but grains and one-shots, which are WAV files. Levels rounded to 0.01 dB, angles to 0.001 rad.
std::string background_json(const DieselModel& model);

/// Errors: InputError. Grains and one-shots stay empty.
DieselModel read_background_json(const std::filesystem::path& file);

}  // namespace rigsound::config
