// write_sound_set FOLDER: a small sound set from formulas, for the packages and for tests: it needs no
// analysis.
#include <cstdio>
#include <exception>

#include "bench/formula_sounds.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"

using namespace rigsound;

namespace {

config::SoundSetIndex write(const SoundSet& sounds, const std::filesystem::path& folder) {
  config::SoundSetIndex index;
  for (const BankUse& use : sounds.uses) {
    const ClickBank& bank = sounds.banks[static_cast<std::size_t>(use.bank)];
    config::save_bank(folder, bank, {"formula_sounds", "", "", "tests"});
    index.banks.push_back({bank.name, use.situation, use.rods, "", 0, 0});
  }
  for (const ToolModel& tool : sounds.tools) {
    config::save_tool(folder, tool);
    index.tools.push_back({tool.name});
  }
  StringModel rods;
  rods.name = "rods";  // what the boom of config/rigs/demo.toml plays
  config::save_string(folder, rods);
  index.tools.push_back({rods.name, config::SteelKind::kString});
  for (DieselModel background : sounds.diesels) {
    background.name = "diesel";  // its own has a space, which a folder may not
    config::save_background(folder, background);
    index.backgrounds.push_back(background.name);
  }
  return index;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: write_sound_set FOLDER\n"), 2;
  try {
    std::filesystem::create_directories(argv[1]);
    config::merge_index(argv[1], write(tools::formula_sounds(), argv[1]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
