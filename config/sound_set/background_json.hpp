// background.json: a diesel in numbers people can read, levels in dB.
#pragma once

#include <string>

#include "json/json_file.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound::config {

constexpr int kBackgroundFormat = 1;

/// Everything but grains and one-shots, which are WAV files. Rounded as the list of fields says.
std::string background_json(const DieselModel& model);

/// Each value in its range. Errors: InputError. Grains and one-shots stay empty.
DieselModel read_background_json(const JsonFile& json);

}  // namespace rigsound::config
