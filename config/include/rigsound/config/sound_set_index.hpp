// soundset.toml: which bank serves which situation, rods and rock. Written by analyze, edited by people.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/situation.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound::config {

/// One [[bank]] of soundset.toml. A bank may serve several situations: one entry each.
struct BankEntry {
  std::string name;  ///< folder under banks/
  Situation situation = Situation::kNormal;
  int rods = 0;               ///< the rod count it was recorded with; 0: any
  std::string rock;           ///< name of a [[rock]]; empty: any
  double feed_bar = 0;        ///< feed pressure it was recorded at; 0: its situation's place in the scene
  double percussion_bar = 0;  ///< percussion pressure it was recorded at; 0: the scene's nominal one
  double gain_db = 0;         ///< trim on top of the bank's own gain
  int line = 0;               ///< in soundset.toml, for messages; 0 when made in memory
};

constexpr Range kRecordedPressures = Range{1, 300, "bar"}.or_zero();
constexpr Range kRockStiffnesses{1e6, 1e11, "N/m"};
constexpr Range kRodCounts = Range{1, 20}.or_zero(), kBankTrims{-60, 24, "dB"};

/// Everything but the name and the situation, which every entry has.
template <class Archive>
void fields(Archive& a, BankEntry& o) {
  a("rods", o.rods, kRodCounts);
  a("rock", o.rock);
  a("feed_bar", o.feed_bar, kRecordedPressures);
  a("percussion_bar", o.percussion_bar, kRecordedPressures);
  a("gain_db", o.gain_db, kBankTrims);
}

/// One [[rock]].
struct RockEntry {
  std::string name;
  double stiffness = Rock{}.stiffness;  ///< loading stiffness of the bit in it
};

template <class Archive>
void fields(Archive& a, RockEntry& o) {
  a("stiffness", o.stiffness, kRockStiffnesses);
}

/// Steps of a stiffness for those who have not measured theirs: force over penetration of a button bit of
/// about 50 mm, as orders of magnitude and not of any one rock. "medium" is what a [[rock]] without stiffness
/// has.
inline const std::vector<RockEntry> kUsualRocks = {
    {"medium"},        ///< limestone, sandstone, gneiss
    {"soft", 5e7},     ///< marl, weak limestone, weathered schist
    {"hard", 5e8},     ///< granite, diabase
    {"hardest", 1e9},  ///< quartzite, taconite
};

enum class SteelKind : std::uint8_t { kBar, kString };
constexpr Word<SteelKind> kSteelKinds[] = {{"bar", SteelKind::kBar}, {"string", SteelKind::kString}};

/// One [[tool]]: a jackhammer's bar or a drill string.
struct ToolEntry {
  std::string name;
  SteelKind kind = SteelKind::kBar;
};

template <class Archive>
void fields(Archive& a, ToolEntry& o) {
  a("kind", o.kind, kSteelKinds);
}

/// One [[laws]]: how the clicks of a rod count and a rock go on beyond the outermost banks, a bar of feed.
struct LawsEntry {
  std::string rock;  ///< name of a [[rock]]; empty: any
  FeedLaws laws;
};

template <class Archive>
void fields(Archive& a, LawsEntry& o) {
  constexpr Range kSlopes{-1, 1, "1/bar"};
  a("rods", o.laws.rods, kRodCounts);
  a("rock", o.rock);
  a("ln_gap", o.laws.ln_gap, kSlopes);
  a("ln_level", o.laws.ln_level, kSlopes);
  a("ln_decay", o.laws.ln_decay, kSlopes);
  a("gap_variation", o.laws.gap_variation, kSlopes);
  a("amplitude_variation", o.laws.amplitude_variation, kSlopes);
  a("tilt_db_per_octave", o.laws.tilt_db_per_octave, kSlopes);
}

struct SoundSetIndex {
  std::vector<BankEntry> banks;
  std::vector<LawsEntry> laws;
  std::vector<RockEntry> rocks;          ///< in the order the machine signal `rock` counts them
  std::vector<ToolEntry> tools;          ///< tools/NAME.json
  std::vector<std::string> backgrounds;  ///< backgrounds/NAME
};

/// Reads SET/soundset.toml. Errors: InputError. Thread: OFF.
SoundSetIndex load_index(const std::filesystem::path& sound_set);

/// The rock of that name in SET/soundset.toml, or else of kUsualRocks; an empty `sound_set` names none.
/// Errors: InputError, with the names there are. Thread: OFF.
RockEntry find_rock(const std::filesystem::path& sound_set, const std::string& name);

/// Adds to SET/soundset.toml what it does not name yet (a bank already listed under the same name and
/// situation counts as named); makes the file, with comments that explain it, when there is none.
/// Everything already in the file, comments and hand edits included, stays as it is.
/// Errors: InputError when the file cannot be read, DeviceError for the disk. Thread: OFF.
void merge_index(const std::filesystem::path& sound_set, const SoundSetIndex& additions);

}  // namespace rigsound::config
