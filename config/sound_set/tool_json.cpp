#include "sound_set/tool_json.hpp"

#include <nlohmann/json.hpp>

#include "json/json_reader.hpp"
#include "json/json_writer.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::config {

std::string tool_json(const ToolModel& tool) {
  nlohmann::ordered_json json;
  json["format"] = kToolFormat;
  JsonWriter(json).write(tool);
  return json.dump(2) + "\n";
}

ToolModel read_tool_json(const JsonFile& json) {
  json.require_format(kToolFormat);
  for (const char* needed : {"length_m", "diameter_m"})
    if (!json.has(needed)) json.fail(needed, "is missing");
  ToolModel tool;
  JsonReader(json, JsonKeys::kSome, {"format"}).read(tool);
  try {
    require_valid(tool, kMaxSampleRate);
  } catch (const InvalidField& error) {
    json.fail(error);
  }
  return tool;
}

std::string string_json(const StringModel& string) {
  nlohmann::ordered_json json;
  json["format"] = kToolFormat;
  JsonWriter(json).write(string);
  return json.dump(2) + "\n";
}

StringModel read_string_json(const JsonFile& json) {
  json.require_format(kToolFormat);
  for (const char* needed : {"rod_length_m", "rod_diameter_m"})
    if (!json.has(needed)) json.fail(needed, "is missing");
  StringModel string;
  JsonReader(json, JsonKeys::kSome, {"format"}).read(string);
  try {
    require_valid(string);
  } catch (const InvalidField& error) {
    json.fail(error);
  }
  return string;
}

}  // namespace rigsound::config
