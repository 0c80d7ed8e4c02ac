// From files, folders and labels to the list of parts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

struct PartList {
  std::vector<std::filesystem::path> read;  ///< recordings, labels, bus logs, rig and its DBC files
  std::vector<Part> parts;                  ///< sorted by recording as given, then by label
  std::vector<std::string> failures;        ///< recordings whose labels cannot be used
  std::vector<std::string> notes;           ///< labels that look wrong
};

/// Bank names are STEM for a whole recording and STEM_STARTms for a labelled part, so that adding labels does
/// not rename banks; recordings that share a stem get the name of their folder in front. Errors: InputError
/// when there is no recording at all, or `labels` goes with several. Thread: OFF.
PartList list_parts(const AnalyzerOptions& options);

}  // namespace rigsound::analysis
