// The sounds of a rig: each boom's tool is found by name among bars and drill strings.
#include "rigsound/config/sounding_rig.hpp"

#include <doctest/doctest.h>

#include "config/sound_set/example_bank.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

config::SoundSetParts parts_with_steel() {
  config::SoundSetParts parts = test::one_bank_set("a");
  parts.tools.resize(2), parts.strings.resize(2);
  parts.tools[0].name = "hex25", parts.tools[1].name = "hex22";
  parts.strings[0].name = "rods38", parts.strings[1].name = "rods45";
  return parts;
}

config::SoundingRig rig_with(const std::vector<std::string>& tools) {
  config::SoundingRig rig;
  rig.file = "rig.toml", rig.sound_set = "set";
  rig.engine.booms.resize(tools.size());
  rig.boom_tools = tools;
  for (std::size_t b = 0; b < tools.size(); ++b) rig.boom_tool_lines.push_back(static_cast<int>(10 + b));
  return rig;
}

}  // namespace

TEST_CASE("a boom's tool is a bar or a drill string of the set") {
  config::SoundingRig rig = rig_with({"hex22", "rods38", "", "rods45"});
  const BoomOptions untouched;
  config::sounds_of(rig, parts_with_steel());
  CHECK(rig.engine.booms[0].tool == 1);
  CHECK(rig.engine.booms[0].drill_string < 0);
  CHECK(rig.engine.booms[1].tool < 0);
  CHECK(rig.engine.booms[1].drill_string == 0);
  CHECK(rig.engine.booms[2].tool == untouched.tool);
  CHECK(rig.engine.booms[2].drill_string == untouched.drill_string);
  CHECK(rig.engine.booms[3].drill_string == 1);
  config::SoundingRig first = rig_with({"hex25"});
  config::sounds_of(first, parts_with_steel());
  CHECK(first.engine.booms[0].tool == 0);
}

TEST_CASE("a tool that the set lacks is refused where the rig names it, with those there are") {
  const auto said = [](config::SoundingRig rig, config::SoundSetParts parts) {
    return test::complaint([&] { config::sounds_of(rig, std::move(parts)); });
  };
  CHECK(
      said(rig_with({"hex25", "hex24"}), parts_with_steel()) ==
      "rig.toml:11: boom.tool: the sound set set has no tool 'hex24', expected one of hex25, hex22, rods38, "
      "rods45");
  config::SoundSetParts none = parts_with_steel();
  none.tools.clear(), none.strings.clear();
  CHECK(said(rig_with({"hex25"}), none) ==
        "rig.toml:10: boom.tool: the sound set set has no tool 'hex25', expected one of none");
  config::SoundingRig packed = rig_with({"hex24"});
  packed.boom_tool_lines.clear();  // a packed rig has no lines
  CHECK(said(packed, parts_with_steel()).rfind("rig.toml: boom.tool: ", 0) == 0);
}

TEST_CASE("a set without a background sounds with the built-in diesel, one with it as it is") {
  config::SoundingRig rig = rig_with({});
  CHECK(config::sounds_of(rig, parts_with_steel()).diesels.size() == 1);
}

TEST_CASE("a packed set says whether it holds a rig") {
  config::PackedSet set;
  CHECK(test::complaint([&] { config::rig_of(set, "x.rigset"); }) ==
        "x.rigset: holds no rig, expected one packed with `rigsound pack --rig`");
  set.rig = config::PackedRig{};
  set.rig->boom_tools = {"hex25"};
  const config::SoundingRig rig = config::rig_of(set, "x.rigset");
  CHECK(rig.boom_tools == std::vector<std::string>{"hex25"});
  CHECK(rig.file == "x.rigset");
  CHECK(rig.sound_set == "x.rigset");
}
