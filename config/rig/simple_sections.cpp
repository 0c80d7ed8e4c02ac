// [audio] [[boom]] [scene] [mix]: what the lists of options say, nothing that depends on other files.
#include "rig/sections.hpp"
#include "rigsound/config/names.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {

audio::AudioOptions read_audio(TomlTable table) { return read_all<audio::AudioOptions>(std::move(table)); }
SceneOptions read_scene(TomlTable table) { return read_all<SceneOptions>(std::move(table)); }
SoundSection read_sound(TomlTable table) { return read_all<SoundSection>(std::move(table)); }

MixSection read_mix(TomlTable table) {
  MixSection section;
  read(table, section.mix);
  read(table, section.calibration);
  table.refuse_unknown();
  return section;
}

Booms read_booms(std::vector<TomlTable> tables) {
  Booms booms;
  for (TomlTable& table : tables) {
    if (booms.options.size() == kMaxBooms)
      table.fail("name", "is boom number " + std::to_string(kMaxBooms + 1) + ", expected at most " +
                             std::to_string(kMaxBooms));
    BoomOptions boom;
    boom.name = "boom" + std::to_string(booms.options.size() + 1);
    read(table, boom);
    if (!is_name(boom.name) || signal_by_name(boom.name))
      table.fail("name", "\"" + boom.name + "\" is no boom name, " + std::string(kNameRule) +
                             ", and no signal's name");
    for (const BoomOptions& other : booms.options)
      if (other.name == boom.name)
        table.fail("name", "\"" + boom.name + "\" is the name of another boom too");
    booms.tools.push_back(table.text("tool", ""));
    booms.tool_lines.push_back(table.line_of("tool"));
    table.refuse_unknown();
    booms.options.push_back(boom);
  }
  if (booms.options.empty()) booms = {{BoomOptions{}}, {""}, {0}};
  return booms;
}

}  // namespace rigsound::config
