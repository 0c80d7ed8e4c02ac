// One part from samples to bank.
#pragma once

#include <vector>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::analysis {

struct PartAnalysis {
  std::vector<std::vector<float>> recorded;  ///< the segments as they were cut
  std::vector<ChainResult> segments;         ///< and what became of each
  BuiltBank built;
};

/// Cuts the part into equal segments of at most 4 s (the paper's method: 2 s), runs the chain on each and
/// builds the bank. Errors: InputError when the label lies outside the recording or no drilling is found.
/// Thread: OFF.
PartAnalysis analyse_part(const Part& part, const Recording& recording, const AnalyzerOptions& options);

}  // namespace rigsound::analysis
