#include "rigsound/config/sound_set_parts.hpp"

#include <algorithm>

#include "rigsound/config/background_files.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/bank_loading.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

void load_banks(const fs::path& sound_set, SoundSetParts& parts, const Progress& progress) {
  ClickStore store(LargeBlock::kPiece);
  for (const BankEntry& entry : parts.index.banks) {
    const bool read = std::any_of(parts.banks.begin(), parts.banks.end(),
                                  [&](const StoredBank& stored) { return stored.bank.name == entry.name; });
    if (read) continue;
    const fs::path folder = sound_set / "banks" / entry.name;
    std::error_code error;
    if (!fs::is_directory(folder, error))
      throw InputError((sound_set / "soundset.toml").string(), entry.line, "bank.name",
                       "there is no folder " + folder.string());
    parts.banks.push_back(load_bank(folder, store));
    show(progress, parts.banks.size(), parts.index.banks.size());
  }
}

}  // namespace

SoundSetParts load_parts(const fs::path& sound_set, const Progress& progress) {
  SoundSetParts parts;
  parts.index = load_index(sound_set);
  require_every_situation(parts.index, (sound_set / "soundset.toml").string());
  load_banks(sound_set, parts, progress);
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

void save_parts(const fs::path& folder, const SoundSetParts& parts, const Progress& progress) {
  std::error_code error;
  if (fs::exists(folder, error)) throw InputError(folder.string(), "is there already, expected a new name");
  AtomicFolder files(folder);
  for (std::size_t i = 0; i < parts.banks.size(); ++i) {
    save_bank(files.temporary(), parts.banks[i].bank, parts.banks[i].provenance);
    show(progress, i + 1, parts.banks.size());
  }
  for (const ToolModel& tool : parts.tools) save_tool(files.temporary(), tool);
  for (const StringModel& string : parts.strings) save_string(files.temporary(), string);
  for (const DieselModel& diesel : parts.diesels) save_background(files.temporary(), diesel);
  merge_index(files.temporary(), parts.index);
  files.commit();
}

}  // namespace rigsound::config
