// One part from samples to bank.
#pragma once

#include <vector>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::analysis {

struct PartAnalysis {
  double start_s = 0;           ///< of the part in it
  std::vector<float> recorded;  ///< kAnalysisRate
  SegmentedResult chain;
  BuiltBank built;
};

/// The part alone, however long its recording is. Errors: InputError when it cannot be read or the label lies
/// outside the recording. Thread: OFF.
Recording read_part(const Part& part);

/// Runs the chain on what read_part() gave and builds the bank. Errors: InputError when no drilling is found,
/// or in a labelled part no clicks.
/// Thread: OFF.
PartAnalysis analyse_part(const Part& part, Recording recording, const AnalyzerOptions& options);

}  // namespace rigsound::analysis
