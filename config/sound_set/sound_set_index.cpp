#include "rigsound/config/sound_set_index.hpp"

#include <algorithm>

#include "rigsound/config/names.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/index_text.hpp"
#include "text/read_text.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

constexpr int kIndexFormat = 1;

constexpr Word<Situation> kSituationWords[] = {{"normal", Situation::kNormal},
                                               {"underfeed", Situation::kUnderfeed},
                                               {"overfeed", Situation::kOverfeed},
                                               {"closed_rattling", Situation::kClosedRattling},
                                               {"open_rattling", Situation::kOpenRattling}};

std::string read_name(TomlTable& table) {
  std::string name = table.required_text("name", "the name of its file or folder");
  if (!is_name(name)) table.fail("name", "\"" + name + "\" is no name, " + std::string(kNameRule));
  return name;
}

void require_named(const TomlTable& table, const std::string& rock, const std::vector<RockEntry>& rocks) {
  const bool named = rock.empty() || std::any_of(rocks.begin(), rocks.end(),
                                                 [&](const RockEntry& entry) { return entry.name == rock; });
  if (!named) table.fail("rock", "\"" + rock + "\" is not named by any [[rock]] of this file");
}

BankEntry read_bank(TomlTable& table, const std::vector<RockEntry>& rocks) {
  BankEntry entry;
  entry.line = table.line_of("name");
  entry.name = read_name(table);
  table.required_text("situation", "one of " + list_of(kSituationWords));
  entry.situation = table.word("situation", Situation::kNormal, kSituationWords);
  read(table, entry);
  require_named(table, entry.rock, rocks);
  table.refuse_unknown();
  return entry;
}

std::vector<std::string> read_names(TomlTable& root, std::string_view key) {
  std::vector<std::string> names;
  for (TomlTable& table : root.tables(key)) {
    const std::string name = read_name(table);
    if (std::find(names.begin(), names.end(), name) != names.end())
      table.fail("name", "\"" + name + "\" is listed twice");
    names.push_back(name);
    table.refuse_unknown();
  }
  return names;
}

/// Entries with a name of their own and what their list of fields says.
template <class Entry>
std::vector<Entry> read_named(TomlTable& root, std::string_view key) {
  std::vector<Entry> entries;
  for (TomlTable& table : root.tables(key)) {
    Entry entry;
    entry.name = read_name(table);
    for (const Entry& other : entries)
      if (other.name == entry.name) table.fail("name", "\"" + entry.name + "\" is listed twice");
    read(table, entry);
    table.refuse_unknown();
    entries.push_back(entry);
  }
  return entries;
}

LawsEntry read_laws(TomlTable& table, const std::vector<RockEntry>& rocks) {
  LawsEntry entry;
  read(table, entry);
  require_named(table, entry.rock, rocks);
  table.refuse_unknown();
  return entry;
}

}  // namespace

SoundSetIndex load_index(const std::filesystem::path& sound_set) {
  std::error_code error;
  if (!std::filesystem::is_directory(sound_set, error))
    throw InputError(sound_set.string(), "is no sound set, expected a folder with soundset.toml");
  const std::filesystem::path file = sound_set / "soundset.toml";
  TomlTable root = TomlTable::parse(read_text(file, kIndexText), file.string());
  const std::int64_t format = root.integer("format", 0, kFormatNumbers);
  if (format != kIndexFormat)
    root.fail("format", "version " + std::to_string(format) + " is not known, expected " +
                            std::to_string(kIndexFormat));
  SoundSetIndex index;
  index.rocks = read_named<RockEntry>(root, "rock");
  index.tools = read_named<ToolEntry>(root, "tool");
  index.backgrounds = read_names(root, "background");
  for (TomlTable& table : root.tables("laws")) index.laws.push_back(read_laws(table, index.rocks));
  for (TomlTable& table : root.tables("bank")) index.banks.push_back(read_bank(table, index.rocks));
  root.refuse_unknown();
  return index;
}

}  // namespace rigsound::config
