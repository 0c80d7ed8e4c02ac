// One part from samples to bank.
#pragma once

#include <vector>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

struct PartAnalysis {
  int source_channels = 0;                   ///< of the recording
  double start_s = 0;                        ///< of the part in it
  std::vector<std::vector<float>> recorded;  ///< the segments as they were cut
  std::vector<ChainResult> segments;         ///< and what became of each
  BuiltBank built;
};

/// Reads the part alone, however long its recording is, cuts it into equal segments of at most 4 s (the
/// paper's method: 2 s), runs the chain on each and builds the bank. Errors: InputError when it cannot be
/// read, the label lies outside the recording or no drilling is found. Thread: OFF.
PartAnalysis analyse_part(const Part& part, const AnalyzerOptions& options);

}  // namespace rigsound::analysis
