#include "sound_set/tool_json.hpp"

#include <initializer_list>

#include "json/json_reader.hpp"
#include "json/json_writer.hpp"
#include "rigsound/config/json.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::config {

namespace {

template <class Model>
std::string json_of(const Model& model) {
  Json json;
  json["format"] = kToolFormat;
  JsonWriter(json).write(model);
  return json_lines(json) + "\n";
}

/// `check` throws InvalidField.
template <class Model, class Check>
Model read_json(const JsonFile& json, std::initializer_list<const char*> needed, Check check) {
  json.require_format(kToolFormat);
  for (const char* key : needed)
    if (!json.has(key)) json.fail(key, "is missing");
  Model model;
  JsonReader(json, JsonKeys::kSome, {"format"}).read(model);
  try {
    check(model);
  } catch (const InvalidField& error) {
    json.fail(error);
  }
  return model;
}

}  // namespace

std::string tool_json(const ToolModel& tool) { return json_of(tool); }
std::string string_json(const StringModel& string) { return json_of(string); }

ToolModel read_tool_json(const JsonFile& json) {
  return read_json<ToolModel>(json, {"length_m", "diameter_m"},
                              [](const ToolModel& tool) { require_valid(tool, kMaxSampleRate); });
}

StringModel read_string_json(const JsonFile& json) {
  return read_json<StringModel>(json, {"rod_length_m", "rod_diameter_m"},
                                [](const StringModel& string) { require_valid(string); });
}

}  // namespace rigsound::config
