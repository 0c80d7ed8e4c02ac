// The part of the report that shows one bank.
#pragma once

#include <string>

#include "analyzer/part_analysis.hpp"

namespace rigsound::analysis {

/// The charts of one bank as HTML, for write_report(). Shows the first segment in which drilling was found.
/// Thread: OFF.
std::string report_section(const PartAnalysis& analysis);

}  // namespace rigsound::analysis
