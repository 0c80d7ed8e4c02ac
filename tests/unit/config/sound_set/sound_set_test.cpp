#include "rigsound/config/sound_set_files.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "config/sound_set/example_bank.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;

TEST_CASE("a merged index keeps comments and hand edits and adds only what is new") {
  TemporaryFolder set;
  config::merge_index(set.path, five_situations("a"));
  const std::filesystem::path file = set.path / "soundset.toml";
  std::string text = content(file);
  text.replace(text.find("gain_db = 0"), 11, "gain_db = -3.5  # too loud in the cabin");
  std::ofstream(file, std::ios::binary) << text;

  config::SoundSetIndex more = five_situations("a");
  config::merge_index(set.path, more);
  CHECK(content(file) == text);

  more = {};
  more.rocks = {{"granite"}};
  more.banks.push_back({"b", Situation::kOverfeed, 3, "granite", 0, 0, 1.25, 0});
  config::merge_index(set.path, more);
  CHECK(content(file).substr(0, text.size()) == text);
  CHECK(content(file).find("\n\n\n") == std::string::npos);
  const config::SoundSetIndex index = config::load_index(set.path);
  REQUIRE(index.banks.size() == 6);
  CHECK(index.banks[0].gain_db == -3.5);
  CHECK(index.banks[5].rods == 3);
  CHECK(index.banks[5].rock == "granite");
  CHECK(index.banks[5].gain_db == 1.25);
}

TEST_CASE("a bank is merged once for each situation") {
  const TemporaryFolder set;
  config::SoundSetIndex index;
  index.banks.resize(1);
  const auto listed_with = [&](const char* name, Situation situation) {
    index.banks[0].name = name;
    index.banks[0].situation = situation;
    config::merge_index(set.path, index);
    return config::load_index(set.path).banks.size();
  };
  CHECK(listed_with("a", Situation::kNormal) == 1);
  CHECK(listed_with("a", Situation::kNormal) == 1);
  CHECK(listed_with("a", Situation::kOverfeed) == 2);
  CHECK(listed_with("b", Situation::kNormal) == 3);
  CHECK(listed_with("a", Situation::kOverfeed) == 3);
}

TEST_CASE("laws, tools and backgrounds are merged by what tells them apart") {
  TemporaryFolder set;
  config::SoundSetIndex index = five_situations("a");
  index.rocks = {{"granite"}};
  index.laws.resize(3);
  index.laws[1].laws.rods = 2;
  index.laws[2].rock = "granite";
  index.tools = {{"bar"}};
  index.backgrounds = {"diesel"};
  config::merge_index(set.path, index);
  const std::string text = content(set.path / "soundset.toml");
  config::merge_index(set.path, index);
  CHECK(content(set.path / "soundset.toml") == text);
  CHECK(config::load_index(set.path).laws.size() == 3);
  index.laws[1].rock = "granite";  // of these rods there are laws, and of this rock, but not of both
  index.tools.push_back({"rods", config::SteelKind::kString});
  index.backgrounds.push_back("other");
  config::merge_index(set.path, index);
  const config::SoundSetIndex again = config::load_index(set.path);
  REQUIRE(again.laws.size() == 4);
  CHECK(again.laws[3].laws.rods == 2);
  CHECK(again.laws[3].rock == "granite");
  REQUIRE(again.tools.size() == 2);
  CHECK(again.tools[1].kind == config::SteelKind::kString);
  CHECK(again.backgrounds == std::vector<std::string>{"diesel", "other"});
}

TEST_CASE("a sound set loads at the engine's rate, each bank once, its trims added") {
  TemporaryFolder set;
  config::save_bank(set.path, example_bank("a", 44100), {});
  config::save_bank(set.path, example_bank("b", 48000), {});
  config::SoundSetIndex index = five_situations("a");
  index.rocks = {{"granite"}, {"limestone", 3e8}};
  index.banks.push_back({"b", Situation::kNormal, 2, "limestone", 0, 0, -4, 0});
  ToolModel tool;
  tool.name = "hex25";
  tool.bar.length_m = 0.45;
  config::save_tool(set.path, tool);
  StringModel rods;
  rods.name = "rods38";
  rods.rod_length_m = 4.27;
  config::save_string(set.path, rods);
  DieselModel diesel = default_diesel();
  diesel.name = "diesel";
  config::save_background(set.path, diesel);
  index.tools = {{"hex25"}, {"rods38", config::SteelKind::kString}};
  index.backgrounds = {"diesel"};
  config::merge_index(set.path, index);

  const SoundSet loaded = config::sound_set_of(config::load_sound_set(set.path), 48000);
  REQUIRE(loaded.banks.size() == 2);
  CHECK(loaded.banks[0].sample_rate == 48000);
  CHECK(loaded.banks[0].mean_gap_samples == doctest::Approx(1600));
  CHECK(loaded.banks[1].gain_db == -6.5);
  REQUIRE(loaded.uses.size() == 6);
  CHECK(loaded.uses[4].situation == Situation::kOpenRattling);
  CHECK(loaded.uses[4].bank == 0);
  CHECK(loaded.uses[5].bank == 1);
  CHECK(loaded.uses[5].rods == 2);
  CHECK(loaded.uses[5].rock == 1);
  REQUIRE(loaded.rocks.size() == 2);
  CHECK(loaded.rocks[0].name == "granite");
  CHECK(loaded.rocks[1].name == "limestone");
  CHECK(loaded.rocks[1].stiffness == 3e8);
  REQUIRE(loaded.tools.size() == 1);
  CHECK(loaded.tools[0].bar.length_m == 0.45);
  REQUIRE(loaded.strings.size() == 1);
  CHECK(loaded.strings[0].rod_length_m == 4.27);
  REQUIRE(loaded.diesels.size() == 1);
  CHECK(loaded.diesels[0].name == "diesel");
}

TEST_CASE("a sound set that cannot be played says what is wrong and where") {
  TemporaryFolder set;
  const std::string file = (set.path / "soundset.toml").string();
  const auto load = [&] { config::sound_set_of(config::load_sound_set(set.path), 48000); };
  CHECK(complaint(load) == file + ": cannot be opened, expected a readable soundset.toml");
  config::merge_index(set.path, five_situations("missing"));
  const std::string text = content(set.path / "soundset.toml");
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<int>(text.find("name = \"missing")), '\n');
  CHECK(complaint(load).find(":" + std::to_string(line) + ": bank.name: there is no folder ") !=
        std::string::npos);
  set.write("soundset.toml", "format = 1\n[[bank]]\nname = \"a\"\nsituation = \"normal\"\n");
  CHECK(complaint(load).find("no bank serves the situation underfeed") != std::string::npos);
  set.write("soundset.toml", "format = 1\n[[bank]]\nname = \"a\"\nsituaton = \"normal\"\n");
  CHECK(complaint(load) == file + ":4: bank.situaton: is not known here, did you mean 'situation'?");
  set.write("soundset.toml", "format = 1\n[[bank]]\nname = \"a\"\n");
  CHECK(complaint(load).find(":2: bank.situation: is missing") != std::string::npos);
  set.write("soundset.toml", "format = 1\n[[bank]]\nname = \"a\"\nsituation = \"norml\"\n");
  CHECK(complaint(load).find(":4: bank.situation: \"norml\" is not known, expected one of normal,") !=
        std::string::npos);
  set.write("soundset.toml", "format = 1\n[[bank]]\nname = \"a\"\nsituation = \"normal\"\nrod = 2\n");
  CHECK(complaint(load) == file + ":5: bank.rod: is not known here, did you mean 'rods'?");
  set.write("soundset.toml", "format = 1\n[[bank]\n");
  CHECK(complaint(load).rfind(file + ":2: ", 0) == 0);
}
