// What a person changed in an analysed bank: banks/NAME/refined.json. bank.json and clicks.wav stay as they
// are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/config/bank_files.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::config {

constexpr int kRefinementFormat = 1;
constexpr const char* kRefinementFile = "refined.json";
constexpr Range kRefinementTrims{-60, 24, "dB"};
constexpr int kLeastRefinedClicks = 2;  ///< that stay in a bank; all of them where it has fewer

struct Refinement {
  DrillControls controls;    ///< the paper's six, neutral unless changed
  std::vector<int> dropped;  ///< places of clicks that are not played, counted from 0
  double trim_db = 0;
};

/// The bank as analysed, whatever people changed. Errors: InputError. Thread: OFF.
StoredBank load_analysed_bank(const std::filesystem::path& bank_folder);

/// Nothing when the bank stands as analysed. Errors: InputError. Thread: OFF.
std::optional<Refinement> load_refinement(const std::filesystem::path& bank_folder);

/// The bank as it is played. Throws InvalidField for a click that is not there, for too few that stay, and
/// for a bank that cannot be played. Thread: OFF.
ClickBank refined(const ClickBank& analysed, const Refinement& refinement);

/// The text of refined.json. Thread: any.
std::string refinement_text(const Refinement& refinement);

}  // namespace rigsound::config
