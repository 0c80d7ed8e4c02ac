#include "analyzer/set_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bank/feed_laws.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

using SeriesKey = std::pair<int, std::string>;  // rods, rock

bool drills(Situation s) { return s != Situation::kClosedRattling && s != Situation::kOpenRattling; }

std::map<SeriesKey, std::vector<FedBank>> series_of_set(const fs::path& sound_set) {
  std::map<SeriesKey, std::vector<FedBank>> series;
  for (const config::BankEntry& entry : config::load_index(sound_set).banks) {
    if (!drills(entry.situation) || !(entry.feed_bar > 0)) continue;
    try {
      ClickBank bank = config::load_bank(sound_set / "banks" / entry.name).bank;
      bank.clicks.clear();
      bank.gain_db += entry.gain_db;
      series[{entry.rods, entry.rock}].push_back({entry.feed_bar, std::move(bank)});
    } catch (const InputError&) {
      continue;  // another shard may be writing it, and `check` tells
    }
  }
  return series;
}

}  // namespace

std::vector<SeriesLaws> laws_of_set(const fs::path& sound_set) {
  std::vector<SeriesLaws> all;
  for (const auto& [key, series] : series_of_set(sound_set)) {
    const auto fitted = fit_feed_laws(series);
    if (!fitted) continue;
    const auto [low, high] = std::minmax_element(
        series.begin(), series.end(), [](const auto& a, const auto& b) { return a.feed_bar < b.feed_bar; });
    SeriesLaws laws;
    laws.entry.laws = *fitted, laws.entry.laws.rods = key.first, laws.entry.rock = key.second;
    laws.banks = static_cast<int>(series.size());
    laws.lowest_bar = low->feed_bar, laws.highest_bar = high->feed_bar;
    all.push_back(laws);
  }
  return all;
}

std::string laws_text(const SeriesLaws& s) {
  const FeedLaws& l = s.entry.laws;
  const auto percent = [](double ln) { return 100 * std::expm1(10 * ln); };
  return fmt::format(
      "{}{}: {} banks at {:g} to {:g} bar; 10 bar more change the rate by {:+.2f} %, the level by {:+.2f} "
      "dB, the "
      "decay time by {:+.1f} %",
      l.rods == 0   ? "any rods"
      : l.rods == 1 ? "1 rod"
                    : fmt::format("{} rods", l.rods),
      s.entry.rock.empty() ? "" : ", " + s.entry.rock, s.banks, s.lowest_bar, s.highest_bar,
      percent(-l.ln_gap), 10 * l.ln_level * 20 / dsp::kLn10, percent(-l.ln_decay));
}

double difference(const FeedLaws& a, const FeedLaws& b) {
  constexpr double kReach_bar = 100;
  return kReach_bar *
         std::max({std::fabs(a.ln_gap - b.ln_gap), std::fabs(a.ln_level - b.ln_level),
                   std::fabs(a.ln_decay - b.ln_decay), std::fabs(a.gap_variation - b.gap_variation),
                   std::fabs(a.amplitude_variation - b.amplitude_variation)});
}

void add_laws(const fs::path& sound_set, const std::string& file, std::vector<std::string>& notes) {
  constexpr double kSame = 0.1;  // within 100 bar: 0.9 dB, or a tenth of a decay time
  const config::SoundSetIndex index = config::load_index(sound_set);
  config::SoundSetIndex additions;
  for (const SeriesLaws& fitted : laws_of_set(sound_set)) {
    const auto known = std::find_if(index.laws.begin(), index.laws.end(), [&](const config::LawsEntry& l) {
      return l.laws.rods == fitted.entry.laws.rods && l.rock == fitted.entry.rock;
    });
    if (known == index.laws.end()) {
      additions.laws.push_back(fitted.entry);
      notes.push_back(file + ": laws of " + laws_text(fitted));
    } else if (difference(known->laws, fitted.entry.laws) > kSame) {
      notes.push_back(file + ": its [[laws]] are kept, but the banks say other: " + laws_text(fitted) +
                      "; remove the entry to have it written anew");
    }
  }
  config::merge_index(sound_set, additions);
}

}  // namespace rigsound::analysis
