#include "rigsound/config/sound_set_parts.hpp"

#include <algorithm>

#include "rigsound/config/background_files.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/atomic_folder.hpp"
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

const StoredBank* bank_named(const std::string& name, const std::vector<StoredBank>& banks) {
  const auto found = std::find_if(banks.begin(), banks.end(),
                                  [&](const StoredBank& stored) { return stored.bank.name == name; });
  return found == banks.end() ? nullptr : &*found;
}

/// Each bank at the engine's rate once, however many situations it serves; with another trim it is another
/// one.
class TrimmedBanks {
 public:
  TrimmedBanks(const SoundSetParts& parts, double sample_rate) : parts_(parts), sample_rate_(sample_rate) {}

  int place(const BankEntry& entry, std::vector<ClickBank>& banks) {
    const std::pair<std::string, double> label(entry.name, entry.gain_db);
    const auto found = std::find(labels_.begin(), labels_.end(), label);
    if (found != labels_.end()) return static_cast<int>(found - labels_.begin());
    banks.push_back(resampled(bank_named(entry.name, parts_.banks)->bank, sample_rate_));
    banks.back().gain_db += entry.gain_db;
    labels_.push_back(label);
    return static_cast<int>(banks.size()) - 1;
  }

 private:
  const SoundSetParts& parts_;
  double sample_rate_;
  std::vector<std::pair<std::string, double>> labels_;
};

void load_banks(const fs::path& sound_set, SoundSetParts& parts) {
  for (const BankEntry& entry : parts.index.banks) {
    if (bank_named(entry.name, parts.banks) != nullptr) continue;
    const fs::path folder = sound_set / "banks" / entry.name;
    std::error_code error;
    if (!fs::is_directory(folder, error))
      throw InputError((sound_set / "soundset.toml").string(), entry.line, "bank.name",
                       "there is no folder " + folder.string());
    parts.banks.push_back(load_bank(folder));
  }
}

}  // namespace

void require_every_situation(const SoundSetIndex& index, const std::string& file) {
  for (const std::string_view situation : kSituationNames) {
    const bool served = std::any_of(index.banks.begin(), index.banks.end(), [&](const BankEntry& entry) {
      return name(entry.situation) == situation;
    });
    if (!served)
      throw InputError(file, 0, "bank",
                       "no bank serves the situation " + std::string(situation) +
                           ", expected at least one [[bank]] for each of the five");
  }
}

SoundSetParts load_parts(const fs::path& sound_set) {
  SoundSetParts parts;
  parts.index = load_index(sound_set);
  require_every_situation(parts.index, (sound_set / "soundset.toml").string());
  load_banks(sound_set, parts);
  for (const ToolEntry& tool : parts.index.tools) {
    const fs::path file = sound_set / "tools" / (tool.name + ".json");
    if (tool.kind == SteelKind::kString)
      parts.strings.push_back(load_string(file));
    else
      parts.tools.push_back(load_tool(file));
  }
  for (const std::string& background : parts.index.backgrounds)
    parts.diesels.push_back(load_background(sound_set / "backgrounds" / background));
  return parts;
}

void save_parts(const fs::path& folder, const SoundSetParts& parts) {
  std::error_code error;
  if (fs::exists(folder, error)) throw InputError(folder.string(), "is there already, expected a new name");
  AtomicFolder files(folder);
  for (const StoredBank& stored : parts.banks) save_bank(files.temporary(), stored.bank, stored.provenance);
  for (const ToolModel& tool : parts.tools) save_tool(files.temporary(), tool);
  for (const StringModel& string : parts.strings) save_string(files.temporary(), string);
  for (const DieselModel& diesel : parts.diesels) save_background(files.temporary(), diesel);
  merge_index(files.temporary(), parts.index);
  files.commit();
}

SoundSet sound_set_of(const SoundSetParts& parts, double sample_rate) {
  SoundSet set;
  for (const RockEntry& rock : parts.index.rocks) set.rocks.push_back({rock.name, rock.stiffness});
  for (const LawsEntry& entry : parts.index.laws) {
    set.laws.push_back(entry.laws);
    set.laws.back().rock = rock_index(parts.index, entry.rock);
  }
  TrimmedBanks banks(parts, sample_rate);
  for (const BankEntry& entry : parts.index.banks)
    set.uses.push_back({entry.situation, entry.rods, rock_index(parts.index, entry.rock),
                        banks.place(entry, set.banks), entry.feed_bar, entry.percussion_bar});
  set.tools = parts.tools;
  set.strings = parts.strings;
  set.diesels = parts.diesels;
  return set;
}

}  // namespace rigsound::config
