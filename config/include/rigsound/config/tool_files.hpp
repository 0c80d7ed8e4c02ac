// A tool on disk: tools/NAME.json.
#pragma once

#include <filesystem>

#include "rigsound/string_model.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::config {

/// Writes SET/tools/NAME.json, atomically. One that is there and differs is kept as NAME.json.old (.old2,
/// ...), whose path is returned. Errors: InputError, DeviceError. Thread: OFF.
std::filesystem::path save_tool(const std::filesystem::path& sound_set, const ToolModel& tool);

/// Reads SET/tools/NAME.json, every value checked. Errors: InputError. Thread: OFF.
ToolModel load_tool(const std::filesystem::path& file);

/// The same for a drill string.
std::filesystem::path save_string(const std::filesystem::path& sound_set, const StringModel& string);
StringModel load_string(const std::filesystem::path& file);

}  // namespace rigsound::config
