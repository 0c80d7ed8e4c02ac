// What makes a run restartable: a bank that is there already, from the same sound and settings.
#pragma once

#include <optional>
#include <string>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

/// Everything but the sound that shaped the bank, as `key=value` words.
std::string settings_of(const Part& part, const AnalyzerOptions& options);

/// The part as an earlier run left it, when its bank is whole and was made from the same bytes with the same
/// settings. Thread: OFF.
std::optional<AnalysedPart> finished_part(const Part& part, const std::string& sha256,
                                          const AnalyzerOptions& options);

/// Writes the bank, its figures and, unless empty, its page; figures come last and mark it
/// as finished. What a person refined in the bank before names clicks that are gone: it is kept under another
/// name, and the note that says so is returned, else nothing. Errors: DeviceError. Thread: OFF.
std::string save_part(const AnalysedPart& analysed, const ClickBank& bank, const std::string& sha256,
                      const std::string& page, const AnalyzerOptions& options);

}  // namespace rigsound::analysis
