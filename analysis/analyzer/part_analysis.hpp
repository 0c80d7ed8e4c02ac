// One part from samples to bank.
#pragma once

#include <vector>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

struct PartAnalysis {
  int source_channels = 0;      ///< of the recording
  double start_s = 0;           ///< of the part in it
  std::vector<float> recorded;  ///< kAnalysisRate
  SegmentedResult chain;
  BuiltBank built;
};

/// Reads the part alone, however long its recording is, runs the chain on it and builds the bank. Errors:
/// InputError when it cannot be read, the label lies outside the recording or no drilling is found. Thread:
/// OFF.
PartAnalysis analyse_part(const Part& part, const AnalyzerOptions& options);

}  // namespace rigsound::analysis
