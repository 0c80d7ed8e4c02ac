// A tool on disk: tools/NAME.json.
#pragma once

#include <filesystem>
#include <string>

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

/// Puts what was kept last of SET/tools/NAME.json back in place, and keeps what stood there instead: twice is
/// as if never. False when nothing was kept. Errors: InputError, DeviceError. Thread: OFF.
bool restore_tool(const std::filesystem::path& sound_set, const std::string& name);

}  // namespace rigsound::config
