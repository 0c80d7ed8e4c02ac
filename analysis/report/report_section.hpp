// The part of the report that shows one bank.
#pragma once

#include <string>

#include "analyzer/part_analysis.hpp"

namespace rigsound::analysis {

/// HTML of one section, with inline SVG and images, for report_page(). Thread: OFF.
std::string report_section(const Part& part, const PartAnalysis& analysis);

}  // namespace rigsound::analysis
