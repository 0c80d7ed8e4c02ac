// The laws of the series that a sound set holds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/config/sound_set_index.hpp"

namespace rigsound::analysis {

struct SeriesLaws {
  config::LawsEntry entry;
  int banks = 0;
  double lowest_bar = 0, highest_bar = 0;
};

/// Of each rod count and rock whose drilling banks name enough feeds (fit_feed_laws), in the order of the
/// file. Banks that are not there are passed over. Errors: InputError when soundset.toml is broken. Thread:
/// OFF.
std::vector<SeriesLaws> laws_of_set(const std::filesystem::path& sound_set);

/// One line for people.
std::string laws_text(const SeriesLaws& laws);

/// How far apart two laws take the sound within 100 bar, in nepers: the largest of their differences.
double difference(const FeedLaws& a, const FeedLaws& b);

/// Adds laws that soundset.toml has not got yet, and makes a note of them and of others that differ. `file`:
/// what the notes call soundset.toml. Errors: InputError, DeviceError. Thread: OFF.
void add_laws(const std::filesystem::path& sound_set, const std::string& file,
              std::vector<std::string>& notes);

}  // namespace rigsound::analysis
