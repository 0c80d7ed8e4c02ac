// One analysed recording on disk: banks/NAME/bank.json and banks/NAME/clicks.wav.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/click_bank.hpp"

namespace rigsound::config {

/// Format version written into bank.json; another one is refused.
constexpr int kBankFormat = 1;

/// Most clicks one clicks.wav carries: the cue chunk of a WAV file read by libsndfile ends at 2500.
constexpr int kMaxBankClicks = 2400;

/// Where a bank came from, so that the same recording is not analysed twice and anybody can trace it.
struct Provenance {
  std::string source_file;    ///< as the user named it
  std::string source_sha256;  ///< of the file's bytes, 64 hex digits; empty: not known
  std::string settings;       ///< every setting that shaped the bank, as `key=value` words
  std::string tool_version;   ///< of the program that wrote it
};

template <class Archive>
void fields(Archive& a, Provenance& o) {
  a("source_file", o.source_file);
  a("source_sha256", o.source_sha256);
  a("settings", o.settings);
  a("tool_version", o.tool_version);
}

/// A file in the bank's folder that is the writer's own.
struct FileBeside {
  std::string name, text;
};

struct StoredBank {
  ClickBank bank;
  Provenance provenance;
};

/// Writes SET/banks/NAME, where NAME is `bank.name` (letters, digits, `_ - .`), and the files that go with
/// it. The folder is whole or absent; an older one of that name is replaced. Errors: InputError for a name or
/// a number that the loader would refuse, DeviceError for the disk. Thread: OFF.
void save_bank(const std::filesystem::path& sound_set, const ClickBank& bank, const Provenance& provenance,
               const std::vector<FileBeside>& beside = {});

/// Reads a bank folder (SET/banks/NAME) at the rate it was recorded with, every value checked: finite,
/// in range, each click between two cue points and of unit norm; as people refined it (refinement.hpp).
/// Errors: InputError. Thread: OFF.
StoredBank load_bank(const std::filesystem::path& bank_folder);

}  // namespace rigsound::config
