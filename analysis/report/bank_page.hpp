// The page of one bank, banks/NAME/report.html, of which the report of a run shows the middle.
#pragma once

#include <filesystem>
#include <string>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

/// A whole page; `section`: what report_section() made. Thread: OFF.
std::string bank_page(const AnalysedPart& part, const std::string& section);

std::filesystem::path bank_page_path(const std::filesystem::path& sound_set, const std::string& bank);

/// The section in the page that lies there; empty when there is none, or one of an older form. Thread: OFF.
std::string section_in(const std::filesystem::path& page);

/// Situation, feed, figures, source and warnings in words, as HTML. Thread: OFF.
std::string bank_words(const AnalysedPart& part);

/// "1 bank", "2 banks". Thread: any.
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace rigsound::analysis
