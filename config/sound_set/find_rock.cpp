#include <algorithm>

#include "rigsound/config/nearest_word.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {

RockEntry find_rock(const std::filesystem::path& sound_set, const std::string& name) {
  const std::filesystem::path file = sound_set / "soundset.toml";
  std::vector<RockEntry> rocks;
  if (!sound_set.empty()) rocks = load_index(sound_set).rocks;
  rocks.insert(rocks.end(), kUsualRocks.begin(), kUsualRocks.end());
  std::vector<std::string> names;
  for (const RockEntry& rock : rocks) {
    if (rock.name == name) return rock;
    names.push_back(rock.name);
  }
  const std::string_view nearest = nearest_word(name, names);
  throw InputError(sound_set.empty() ? "--rock" : file.string(), 0, sound_set.empty() ? "" : "rock",
                   "is \"" + name + "\", expected " + list_of(names) +
                       (nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?"));
}

}  // namespace rigsound::config
