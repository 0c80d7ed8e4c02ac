// The part of the report that shows one bank.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/analysis/chain.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// A part of a recording and the bank that was made of it.
struct ReportedPart {
  const std::vector<float>& recorded;  ///< kAnalysisRate
  double start_s = 0;                  ///< of the part in its recording
  const std::vector<DrillingSegment>& drilling;
  const ClickBank& bank;
};

/// The charts of one bank as HTML, for write_report(). Shows the first segment in which drilling was found.
/// Thread: OFF.
std::string report_section(const ReportedPart& part);

/// Where the section lies beside its bank: banks/NAME/report.html
std::filesystem::path report_section_path(const std::filesystem::path& sound_set, const std::string& bank);

}  // namespace rigsound::analysis
