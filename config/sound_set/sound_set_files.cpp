#include "rigsound/config/sound_set_files.hpp"

#include <algorithm>
#include <utility>

#include "rigsound/config/background_files.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

int rock_index(const SoundSetIndex& index, const std::string& rock) {
  if (rock.empty()) return -1;
  const auto found = std::find_if(index.rocks.begin(), index.rocks.end(),
                                  [&](const RockEntry& entry) { return entry.name == rock; });
  return static_cast<int>(found - index.rocks.begin());
}

void require_every_situation(const fs::path& file, const SoundSetIndex& index) {
  for (const std::string_view situation : kSituationNames) {
    const bool served = std::any_of(index.banks.begin(), index.banks.end(), [&](const BankEntry& entry) {
      return name(entry.situation) == situation;
    });
    if (!served)
      throw InputError(file.string(), 0, "bank",
                       "no bank serves the situation " + std::string(situation) +
                           ", expected at least one [[bank]] for each of the five");
  }
}

/// Loads each bank once, however many situations it serves; with another trim it is another bank.
class BankShelf {
 public:
  BankShelf(fs::path folder, fs::path index_file, double sample_rate)
      : folder_(std::move(folder)), index_file_(std::move(index_file)), sample_rate_(sample_rate) {}

  int place(const BankEntry& entry, std::vector<ClickBank>& banks) {
    const std::pair<std::string, double> label(entry.name, entry.gain_db);
    const auto found = std::find(labels_.begin(), labels_.end(), label);
    if (found != labels_.end()) return static_cast<int>(found - labels_.begin());
    std::error_code error;
    if (!fs::is_directory(folder_ / entry.name, error))
      throw InputError(index_file_.string(), entry.line, "bank.name",
                       "there is no folder " + (folder_ / entry.name).string());
    banks.push_back(resampled(load_bank(folder_ / entry.name).bank, sample_rate_));
    banks.back().gain_db += entry.gain_db;
    labels_.push_back(label);
    return static_cast<int>(banks.size()) - 1;
  }

 private:
  fs::path folder_, index_file_;
  double sample_rate_;
  std::vector<std::pair<std::string, double>> labels_;
};

}  // namespace

SoundSet load_sound_set(const fs::path& sound_set, double sample_rate) {
  const SoundSetIndex index = load_index(sound_set);
  const fs::path index_file = sound_set / "soundset.toml";
  require_every_situation(index_file, index);
  SoundSet set;
  for (const RockEntry& rock : index.rocks) set.rocks.push_back({rock.name, rock.stiffness});
  for (const LawsEntry& entry : index.laws) {
    set.laws.push_back(entry.laws);
    set.laws.back().rock = rock_index(index, entry.rock);
  }
  BankShelf shelf(sound_set / "banks", index_file, sample_rate);
  for (const BankEntry& entry : index.banks)
    set.uses.push_back({entry.situation, entry.rods, rock_index(index, entry.rock),
                        shelf.place(entry, set.banks), entry.feed_bar, entry.percussion_bar});
  for (const ToolEntry& tool : index.tools) {
    const fs::path file = sound_set / "tools" / (tool.name + ".json");
    if (tool.kind == SteelKind::kString)
      set.strings.push_back(load_string(file));
    else
      set.tools.push_back(load_tool(file));
  }
  for (const std::string& background : index.backgrounds)
    set.diesels.push_back(load_background(sound_set / "backgrounds" / background));
  return set;
}

}  // namespace rigsound::config
