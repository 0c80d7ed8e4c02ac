// tools/NAME.json as text and back.
#pragma once

#include <string>

#include "json/json_file.hpp"
#include "rigsound/string_model.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::config {

constexpr int kToolFormat = 2;  ///< of tools/NAME.json

std::string tool_json(const ToolModel& tool);

/// Keys left out keep their defaults; unknown keys, wrong types and senseless values are refused.
ToolModel read_tool_json(const JsonFile& json);

/// The same for a drill string.
std::string string_json(const StringModel& string);
StringModel read_string_json(const JsonFile& json);

}  // namespace rigsound::config
