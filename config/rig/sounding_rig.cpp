// The engine of a rig whose sound set is read. Reads no file, so that a browser can do it too.
#include <stdexcept>
#include <utility>

#include "rigsound/config/sounding_rig.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace {

template <class Model>
int index_of(const std::vector<Model>& models, const std::string& name) {
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].name == name) return static_cast<int>(i);
  return -1;
}

std::string steel_names(const SoundSet& sounds) {
  std::string names;
  for (const ToolModel& tool : sounds.tools) append_to_list(names, tool.name);
  for (const StringModel& string : sounds.strings) append_to_list(names, string.name);
  return names.empty() ? "none" : names;
}

}  // namespace

SoundSet sounds_of(SoundingRig& rig, SoundSetParts parts) {
  SoundSet sounds = sound_set_of(std::move(parts), rig.engine.sample_rate);
  for (std::size_t i = 0; i < rig.boom_tools.size(); ++i) {
    const std::string& wanted = rig.boom_tools[i];
    if (wanted.empty()) continue;
    BoomOptions& boom = rig.engine.booms[i];
    boom.tool = index_of(sounds.tools, wanted);
    boom.drill_string = index_of(sounds.strings, wanted);
    if (boom.tool < 0 && boom.drill_string < 0)
      throw InputError(rig.file.string(), i < rig.boom_tool_lines.size() ? rig.boom_tool_lines[i] : 0,
                       "boom.tool",
                       "the sound set " + rig.sound_set.string() + " has no tool '" + wanted +
                           "', expected one of " + steel_names(sounds));
  }
  if (sounds.diesels.empty()) sounds.diesels.push_back(default_diesel());
  return sounds;
}

SoundingRig rig_of(const PackedSet& set, const std::filesystem::path& file) {
  if (!set.rig)
    throw InputError(file.string(), "holds no rig, expected one packed with `rigsound pack --rig`");
  SoundingRig rig;
  rig.file = rig.sound_set = file;
  rig.engine = set.rig->engine;
  rig.boom_tools = set.rig->boom_tools;
  return rig;
}

Engine build_engine(const SoundingRig& rig, SoundSet sounds) {
  try {
    return Engine(rig.engine, std::move(sounds));
  } catch (const std::invalid_argument& error) {
    throw InputError(rig.sound_set.string(), std::string("cannot be played: ") + error.what());
  }
}

}  // namespace rigsound::config
