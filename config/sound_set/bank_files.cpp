#include "rigsound/config/bank_files.hpp"

#include <cmath>

#include "rigsound/config/names.hpp"
#include "rigsound/config/refinement.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/bank_json.hpp"
#include "sound_set/bank_loading.hpp"
#include "sound_set/clicks_wav.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

StoredBank analysed_bank(const fs::path& bank_folder, ClickStore& store) {
  std::error_code error;
  if (!fs::is_directory(bank_folder, error))
    throw InputError(bank_folder.string(), "is no bank folder, expected one with bank.json and clicks.wav");
  const JsonFile json(bank_folder / "bank.json");
  StoredBank stored = read_bank_json(json);
  stored.bank.name = bank_folder.filename().string();
  stored.bank.clicks =
      read_clicks_wav(bank_folder / "clicks.wav", static_cast<int>(stored.bank.sample_rate), store);
  try {
    require_valid_numbers(stored.bank);  // clicks were checked as they were read
  } catch (const InvalidField& invalid) {
    json.fail(invalid);
  }
  return stored;
}

}  // namespace

void save_bank(const fs::path& sound_set, const ClickBank& bank, const Provenance& provenance,
               const std::vector<FileBeside>& beside) {
  const fs::path folder = sound_set / "banks" / bank.name;
  if (!is_name(bank.name))
    throw InputError(sound_set.string(), 0, bank.name, "is no bank name, " + std::string(kNameRule));
  if (bank.clicks.empty() || bank.clicks.size() > kMaxBankClicks)
    throw InputError(
        folder.string(), 0, "clicks",
        std::to_string(bank.clicks.size()) + " clicks, expected 1 to " + std::to_string(kMaxBankClicks));
  AtomicFolder files(folder);
  write_file(files.temporary() / "bank.json", bank_json(bank, provenance));
  write_clicks_wav(files.temporary() / "clicks.wav", bank.clicks,
                   static_cast<int>(std::lround(bank.sample_rate)));
  for (const FileBeside& file : beside) write_file(files.temporary() / file.name, file.text);
  load_bank(files.temporary());  // what the loader would refuse is refused before it is in place
  files.commit();
}

StoredBank load_analysed_bank(const fs::path& bank_folder) {
  ClickStore store;
  return analysed_bank(bank_folder, store);
}

StoredBank load_bank(const fs::path& bank_folder, ClickStore& store) {
  StoredBank stored = analysed_bank(bank_folder, store);
  const std::optional<Refinement> refinement = load_refinement(bank_folder);
  if (!refinement) return stored;
  try {
    stored.bank = refined(stored.bank, *refinement);
  } catch (const InvalidField& invalid) {
    throw InputError((bank_folder / kRefinementFile).string(), 0, invalid.key(), invalid.problem());
  }
  return stored;
}

StoredBank load_bank(const fs::path& bank_folder) {
  ClickStore store;
  return load_bank(bank_folder, store);
}

}  // namespace rigsound::config
