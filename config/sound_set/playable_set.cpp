// From what is stored to what the engine plays. Reads no file, so that a browser can do it too.
#include <algorithm>
#include <utility>

#include "rigsound/config/sound_set_parts.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/bank_resampling.hpp"

namespace rigsound::config {
namespace {

int rock_index(const SoundSetIndex& index, const std::string& rock) {
  if (rock.empty()) return -1;
  const auto found = std::find_if(index.rocks.begin(), index.rocks.end(),
                                  [&](const RockEntry& entry) { return entry.name == rock; });
  return static_cast<int>(found - index.rocks.begin());
}

/// Each bank at the engine's rate once, however many situations it serves; with another trim it is another
/// one.
class TrimmedBanks {
 public:
  TrimmedBanks(std::vector<StoredBank> stored, double sample_rate)
      : stored_(std::move(stored)), resampler_(sample_rate) {}

  int place(const BankEntry& entry) {
    const auto found = std::find_if(placed_.begin(), placed_.end(),
                                    [&](const Placed& p) { return p.is(entry.name, entry.gain_db); });
    if (found != placed_.end()) return static_cast<int>(found - placed_.begin());
    banks_.push_back(untrimmed(entry.name));
    placed_.push_back({entry.name, entry.gain_db, banks_.back().gain_db});
    banks_.back().gain_db += entry.gain_db;
    return static_cast<int>(banks_.size()) - 1;
  }

  std::vector<ClickBank> take() { return std::move(banks_); }

 private:
  struct Placed {
    std::string name;
    double trim_db, own_gain_db;
    bool is(const std::string& other, double db) const { return name == other && trim_db == db; }
  };

  /// The clicks of a set are most of it: those that nobody plays twice are never there twice.
  ClickBank untrimmed(const std::string& name) {
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (placed_[i].name == name) {
        ClickBank bank = banks_[i];
        bank.gain_db = placed_[i].own_gain_db;
        return bank;
      }
    const auto found = std::find_if(stored_.begin(), stored_.end(),
                                    [&](const StoredBank& stored) { return stored.bank.name == name; });
    return resampler_.resampled(std::move(found->bank));
  }

  std::vector<StoredBank> stored_;
  BankResampler resampler_;
  std::vector<ClickBank> banks_;
  std::vector<Placed> placed_;  ///< what each of banks_ is
};

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

SoundSet sound_set_of(SoundSetParts parts, double sample_rate) {
  SoundSet set;
  for (const RockEntry& rock : parts.index.rocks) set.rocks.push_back({rock.name, rock.stiffness});
  for (const LawsEntry& entry : parts.index.laws) {
    set.laws.push_back(entry.laws);
    set.laws.back().rock = rock_index(parts.index, entry.rock);
  }
  TrimmedBanks banks(std::move(parts.banks), sample_rate);
  for (const BankEntry& entry : parts.index.banks)
    set.uses.push_back({entry.situation, entry.rods, rock_index(parts.index, entry.rock), banks.place(entry),
                        entry.feed_bar, entry.percussion_bar});
  set.banks = banks.take();
  set.tools = std::move(parts.tools);
  set.strings = std::move(parts.strings);
  set.diesels = std::move(parts.diesels);
  return set;
}

}  // namespace rigsound::config
