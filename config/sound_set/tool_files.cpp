#include "rigsound/config/tool_files.hpp"

#include <nlohmann/json.hpp>

#include "json/json_file.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/input_error.hpp"
#include "sound_set/names.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

constexpr int kToolFormat = 1;

struct Field {
  const char* key;
  double ToolModel::*member;
  double min, max;
};

constexpr Field kFields[] = {
    {"length_m", &ToolModel::length_m, 0.3, 1.0}, {"diameter_m", &ToolModel::diameter_m, 0.015, 0.05},
    {"k_L", &ToolModel::k_L, 0, 0.99999},         {"k_Tmin", &ToolModel::k_Tmin, 0, 0.99999},
    {"k_Tmax", &ToolModel::k_Tmax, 0, 0.99999},
};

}  // namespace

void save_tool(const fs::path& sound_set, const ToolModel& tool) {
  const fs::path folder = sound_set / "tools";
  if (!is_name(tool.name))
    throw InputError(folder.string(), 0, tool.name, "is no tool name, " + std::string(kNameRule));
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw DeviceError(folder.string() + ": cannot be made: " + error.message());
  nlohmann::ordered_json json;
  json["format"] = kToolFormat;
  for (const Field& field : kFields) json[field.key] = tool.*field.member;
  write_file(folder / (tool.name + ".json"), json.dump(2) + "\n");
}

ToolModel load_tool(const fs::path& file) {
  const JsonFile json(file);
  json.require_format(kToolFormat);
  ToolModel tool;
  tool.name = file.stem().string();
  for (const Field& field : kFields) tool.*field.member = json.number(field.key, field.min, field.max);
  return tool;
}

}  // namespace rigsound::config
