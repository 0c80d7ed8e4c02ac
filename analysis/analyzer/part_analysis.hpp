// One part from samples to bank.
#pragma once

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::analysis {

struct PartAnalysis {
  double start_s = 0;  ///< of the part in its recording
  Samples recorded;
  SegmentedResult chain;
  BuiltBank built;
};

/// The part alone, its sound kept in `file`. Errors: InputError when it cannot be read or the label lies
/// outside the recording. Thread: OFF.
LongRecording read_part(const Part& part, SampleFile& file);

/// Runs the chain on what read_part() gave, keeps the drilling in `file` too, and builds the bank. Errors:
/// InputError when no drilling is found, or in a labelled part no clicks. Thread: OFF.
PartAnalysis analyse_part(const Part& part, const Samples& recorded, SampleFile& file,
                          const AnalyzerOptions& options);

}  // namespace rigsound::analysis
