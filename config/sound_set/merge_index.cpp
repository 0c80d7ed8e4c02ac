#include <algorithm>
#include <set>

#include "rigsound/config/names.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/index_text.hpp"
#include "text/read_text.hpp"
#include "toml/toml_writer.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

void require_name(const fs::path& file, std::string_view kind, const std::string& name) {
  if (!is_name(name))
    throw InputError(file.string(), 0, kind, "\"" + name + "\" is no name, " + std::string(kNameRule));
}

std::string new_names(const fs::path& file, std::string_view kind, const std::vector<std::string>& known,
                      const std::vector<std::string>& wanted) {
  std::string text;
  for (const std::string& name : wanted) {
    require_name(file, kind, name);
    if (std::find(known.begin(), known.end(), name) == known.end()) text += index_name_text(kind, name);
  }
  return text;
}

/// Texts of the wanted entries that are not known; one wanted twice is added once.
template <class Entry>
std::string new_entries(const fs::path& file, std::string_view kind, const std::vector<Entry>& known,
                        const std::vector<Entry>& wanted) {
  std::string text;
  std::set<std::string> listed;
  for (const Entry& entry : known) listed.insert(entry.name);
  for (const Entry& entry : wanted) {
    require_name(file, kind, entry.name);
    if (listed.insert(entry.name).second) text += index_name_text(kind, entry.name) + toml_text(entry);
  }
  return text;
}

bool lists(const SoundSetIndex& index, const LawsEntry& wanted) {
  return std::any_of(index.laws.begin(), index.laws.end(), [&](const LawsEntry& entry) {
    return entry.laws.rods == wanted.laws.rods && entry.rock == wanted.rock;
  });
}

bool lists(const SoundSetIndex& index, const BankEntry& wanted) {
  return std::any_of(index.banks.begin(), index.banks.end(), [&](const BankEntry& entry) {
    return entry.name == wanted.name && entry.situation == wanted.situation;
  });
}

}  // namespace

void merge_index(const fs::path& sound_set, const SoundSetIndex& additions) {
  const fs::path file = sound_set / "soundset.toml";
  std::error_code error;
  const bool exists = fs::exists(file, error);
  const SoundSetIndex index = exists ? load_index(sound_set) : SoundSetIndex{};

  std::string added = new_entries(file, "rock", index.rocks, additions.rocks) +
                      new_entries(file, "tool", index.tools, additions.tools) +
                      new_names(file, "background", index.backgrounds, additions.backgrounds);
  for (const BankEntry& entry : additions.banks) {
    require_name(file, "bank", entry.name);
    if (!lists(index, entry)) added += index_bank_text(entry);
  }
  for (const LawsEntry& entry : additions.laws)
    if (!lists(index, entry)) added += index_laws_text(entry);
  if (exists && added.empty()) return;

  make_folders(sound_set);
  std::string text = exists ? read_text(file, kIndexText) : index_preamble();
  if (!text.empty() && text.back() != '\n') text += '\n';
  write_file(file, text + added);
}

}  // namespace rigsound::config
