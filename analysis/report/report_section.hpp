// The part of the report that shows one bank.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/chain.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// A part of a recording and the bank that was made of it.
struct ReportedPart {
  const Samples& recorded;
  double start_s = 0;                         ///< of the part in its recording
  const std::vector<VerdictWindow>& verdict;  ///< times from the part's start on
  const std::vector<DrillingSegment>& drilling;
  const ClickBank& bank;
};

/// Sound, figures and charts of one bank as HTML. Shows the first segment in which drilling was found.
/// Thread: OFF.
std::string report_section(const ReportedPart& part);

/// The symbols of its figures in words; once a page. Thread: OFF.
std::string symbol_legend();

}  // namespace rigsound::analysis
