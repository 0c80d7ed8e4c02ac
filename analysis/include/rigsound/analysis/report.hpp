// One page that shows what was analysed and what the banks will play.
#pragma once

#include <filesystem>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

/// Writes a self-contained HTML page: figures and warnings of all banks of `result`, what failed, and the
/// middle of the page that run_analyzer left with each bank (ReportSections::kWrite), which it links to. The
/// sound of the first 24 banks is in it. Errors: DeviceError. Thread: OFF.
void write_report(const std::filesystem::path& path, const std::filesystem::path& sound_set,
                  const AnalyzerResult& result);

}  // namespace rigsound::analysis
