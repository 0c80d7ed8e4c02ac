// soundset.toml: which bank serves which situation, rods and rock. Written by analyze, edited by people.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::config {

/// One [[bank]] of soundset.toml. A bank may serve several situations: one entry each.
struct BankEntry {
  std::string name;  ///< folder under banks/
  Situation situation = Situation::kNormal;
  int rods = 0;        ///< the rod count it was recorded with; 0: any
  std::string rock;    ///< name of a [[rock]]; empty: any
  double gain_db = 0;  ///< trim on top of the bank's own gain
  int line = 0;        ///< in soundset.toml, for messages; 0 when made in memory
};

constexpr Range kRodCounts = Range{1, 20}.or_zero(), kBankTrims{-60, 24, "dB"};

/// Everything but the name and the situation, which every entry has.
template <class Archive>
void fields(Archive& a, BankEntry& o) {
  a("rods", o.rods, kRodCounts);
  a("rock", o.rock);
  a("gain_db", o.gain_db, kBankTrims);
}

struct SoundSetIndex {
  std::vector<BankEntry> banks;
  std::vector<std::string> rocks;        ///< in the order the machine signal `rock` counts them
  std::vector<std::string> tools;        ///< tools/NAME.json
  std::vector<std::string> backgrounds;  ///< backgrounds/NAME
};

/// Reads SET/soundset.toml. Errors: InputError. Thread: OFF.
SoundSetIndex load_index(const std::filesystem::path& sound_set);

/// Adds to SET/soundset.toml what it does not name yet (a bank already listed under the same name and
/// situation counts as named); makes the file, with comments that explain it, when there is none.
/// Everything already in the file, comments and hand edits included, stays as it is.
/// Errors: InputError when the file cannot be read, DeviceError for the disk. Thread: OFF.
void merge_index(const std::filesystem::path& sound_set, const SoundSetIndex& additions);

}  // namespace rigsound::config
