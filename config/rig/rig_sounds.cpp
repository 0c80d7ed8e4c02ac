#include <algorithm>
#include <stdexcept>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/default_diesel.hpp"
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
  for (const ToolModel& tool : sounds.tools) names += (names.empty() ? "" : ", ") + tool.name;
  for (const StringModel& string : sounds.strings) names += (names.empty() ? "" : ", ") + string.name;
  return names.empty() ? "none" : names;
}

}  // namespace

SoundSet load_sounds(Rig& rig) {
  if (rig.sound_set.empty())
    throw InputError(rig.file.string(), rig.sound_set_line, "sound.set",
                     "is missing, expected the folder of a sound set");
  std::error_code error;
  if (!std::filesystem::exists(rig.sound_set, error))
    throw InputError(rig.file.string(), rig.sound_set_line, "sound.set",
                     "there is no folder " + rig.sound_set.string() + ", expected a sound set");
  return sounds_of(rig, load_sound_set(rig.sound_set));
}

SoundSet sounds_of(Rig& rig, const SoundSetParts& parts) {
  SoundSet sounds = sound_set_of(parts, rig.engine.sample_rate);
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

Rig rig_of(const PackedSet& set, const std::filesystem::path& file) {
  if (!set.rig)
    throw InputError(file.string(), "holds no rig, expected one packed with `rigsound pack --rig`");
  Rig rig;
  rig.file = rig.sound_set = file;
  rig.engine = set.rig->engine;
  rig.boom_tools = set.rig->boom_tools;
  return rig;
}

Engine build_engine(const Rig& rig, SoundSet sounds) {
  try {
    return Engine(rig.engine, std::move(sounds));
  } catch (const std::invalid_argument& error) {
    throw InputError(rig.sound_set.string(), std::string("cannot be played: ") + error.what());
  }
}

}  // namespace rigsound::config
