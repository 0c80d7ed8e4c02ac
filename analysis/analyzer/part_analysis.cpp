#include "analyzer/part_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

std::string title(const Part& part) {
  if (part.whole()) return part.recording.string();
  return fmt::format("{} [{:.3f}-{:.3f} s]", part.recording.string(), part.label.start_s, part.label.end_s);
}

}  // namespace

LongRecording read_part(const Part& part, SampleFile& file) {
  if (part.whole()) return read_long_recording(part.recording, {}, file);
  const double duration = recording_seconds(part.recording);
  if (part.label.end_s > duration + kLabelSlack_s)
    throw InputError(part.labels.string(), part.label.line, "end",
                     fmt::format("{} s is behind the recording's end, expected at most {:.3f} s",
                                 part.label.end_s, duration));
  if (std::min(part.label.end_s, duration) - part.label.start_s < kMinRecordingSeconds)
    throw InputError(part.labels.string(), part.label.line, "end",
                     fmt::format("the part is {:.3f} s long, expected {} s or more",
                                 part.label.end_s - part.label.start_s, kMinRecordingSeconds));
  return read_long_recording(part.recording, {part.label.start_s, part.label.end_s}, file);
}

PartAnalysis analyse_part(const Part& part, const Samples& recorded, SampleFile& file,
                          const AnalyzerOptions& options) {
  PartAnalysis analysis;
  analysis.start_s = part.label.start_s;
  analysis.recorded = recorded;
  ChainOptions chain;
  chain.method = options.method;
  chain.denoise = options.denoise;
  chain.labelled = part.labelled;
  chain.machine = options.machine;
  analysis.chain = run_chain_in_segments(recorded, file, chain);
  const ChainResult& whole = analysis.chain.joined;
  if (!whole.drilling_found)
    throw InputError(title(part), fmt::format("no {} found ({}), expected percussive drilling",
                                              part.labelled ? "clicks" : "drilling", whole.reason));
  analysis.built = build_bank(analysis.chain, options.method, options.clicks, title(part));
  analysis.built.bank.name = part.bank;
  analysis.built.figures.machine = options.machine;
  for (const Machine& machine : whole.machines)
    analysis.built.figures.machine_rates_hz.push_back(machine.rate_hz);
  analysis.built.figures.doubt = whole.reason;
  return analysis;
}

}  // namespace rigsound::analysis
