#include "rigsound/config/tool_files.hpp"

#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/input_error.hpp"
#include "sound_set/names.hpp"
#include "sound_set/tool_json.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

void save_tool(const fs::path& sound_set, const ToolModel& tool) {
  const fs::path folder = sound_set / "tools";
  if (!is_name(tool.name))
    throw InputError(folder.string(), 0, tool.name, "is no tool name, " + std::string(kNameRule));
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw DeviceError(folder.string() + ": cannot be made: " + error.message());
  write_file(folder / (tool.name + ".json"), tool_json(tool));
}

ToolModel load_tool(const fs::path& file) {
  ToolModel tool = read_tool_json(JsonFile(file));
  tool.name = file.stem().string();
  return tool;
}

}  // namespace rigsound::config
