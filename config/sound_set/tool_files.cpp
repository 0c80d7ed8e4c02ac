#include "rigsound/config/tool_files.hpp"

#include "rigsound/config/names.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/tool_json.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

/// The name of what is kept as the i-th, from 1 on: NAME.json.old, .old2, .old3, ...
fs::path kept_file(const fs::path& file, int i) {
  return file.string() + ".old" + (i > 1 ? std::to_string(i) : std::string());
}

/// The first of them that is free: hand-made edits are never lost.
int first_free(const fs::path& file) {
  int i = 1;
  while (fs::exists(kept_file(file, i))) ++i;
  return i;
}

fs::path put_aside(const fs::path& file) {
  fs::path kept = kept_file(file, first_free(file));
  std::error_code error;
  fs::copy_file(file, kept, error);
  if (error) throw DeviceError(kept.string() + ": cannot be written: " + error.message());
  return kept;
}

/// Writes tools/NAME.json; a file of that name that says something else is put aside, and where is returned.
fs::path save(const fs::path& sound_set, const std::string& name, const std::string& text) {
  const fs::path folder = sound_set / "tools";
  if (!is_name(name))
    throw InputError(folder.string(), 0, name, "is no tool name, " + std::string(kNameRule));
  make_folders(folder);
  const fs::path file = folder / (name + ".json");
  const bool differs = fs::exists(file) && read_text(file, kModelText) != text;
  fs::path kept = differs ? put_aside(file) : fs::path();
  write_file(file, text);
  return kept;
}

}  // namespace

fs::path save_tool(const fs::path& sound_set, const ToolModel& tool) {
  return save(sound_set, tool.name, tool_json(tool));
}

fs::path save_string(const fs::path& sound_set, const StringModel& string) {
  return save(sound_set, string.name, string_json(string));
}

bool restore_tool(const fs::path& sound_set, const std::string& name) {
  if (!is_name(name))
    throw InputError(sound_set.string(), 0, name, "is no tool name, " + std::string(kNameRule));
  const fs::path file = sound_set / "tools" / (name + ".json");
  const int last = first_free(file) - 1;
  if (last == 0) return false;
  const fs::path kept = kept_file(file, last);
  const std::string before = read_text(kept, kModelText), after = read_text(file, kModelText);
  write_file(file, before);
  write_file(kept, after);
  return true;
}

ToolModel load_tool(const fs::path& file) {
  ToolModel tool = read_tool_json(JsonFile(file));
  tool.name = file.stem().string();
  return tool;
}

StringModel load_string(const fs::path& file) {
  StringModel string = read_string_json(JsonFile(file));
  string.name = file.stem().string();
  return string;
}

}  // namespace rigsound::config
