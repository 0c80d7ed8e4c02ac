#include "analyzer/part_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bank/segment.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLongestSegment_s = 4, kLongestPaperSegment_s = 2;

std::string title(const Part& part) {
  if (part.whole()) return part.recording.string();
  return fmt::format("{} [{:.3f}-{:.3f} s]", part.recording.string(), part.label.start_s, part.label.end_s);
}

Recording read_part(const Part& part) {
  if (part.whole()) return read_recording(part.recording);
  const double duration = recording_seconds(part.recording);
  if (part.label.end_s > duration + kLabelSlack_s)
    throw InputError(part.labels.string(), part.label.line, "end",
                     fmt::format("{} s is behind the recording's end, expected at most {:.3f} s",
                                 part.label.end_s, duration));
  if (std::min(part.label.end_s, duration) - part.label.start_s < kMinRecordingSeconds)
    throw InputError(part.labels.string(), part.label.line, "end",
                     fmt::format("the part is {:.3f} s long, expected {} s or more",
                                 part.label.end_s - part.label.start_s, kMinRecordingSeconds));
  return read_recording(part.recording, {part.label.start_s, part.label.end_s});
}

std::vector<std::vector<float>> segments_of(const std::vector<float>& mono, double longest_s) {
  const auto size = static_cast<long>(mono.size());
  const long count = std::max(
      1L, static_cast<long>(std::ceil(static_cast<double>(size) / (longest_s * kAnalysisRate) - 1e-9)));
  std::vector<std::vector<float>> segments;
  for (long i = 0; i < count; ++i)
    segments.emplace_back(mono.begin() + size * i / count, mono.begin() + size * (i + 1) / count);
  return segments;
}

}  // namespace

PartAnalysis analyse_part(const Part& part, const AnalyzerOptions& options) {
  const Recording recording = read_part(part);
  PartAnalysis analysis;
  analysis.source_channels = recording.source_channels;
  analysis.start_s = part.label.start_s;
  const bool paper = options.method == Method::kPaper;
  analysis.recorded = segments_of(recording.mono, paper ? kLongestPaperSegment_s : kLongestSegment_s);
  ChainOptions chain;
  chain.method = options.method;
  chain.denoise = options.denoise;
  for (const std::vector<float>& segment : analysis.recorded)
    analysis.segments.push_back(run_chain(segment, chain));
  if (std::none_of(analysis.segments.begin(), analysis.segments.end(), has_drilling))
    throw InputError(title(part), fmt::format("no drilling found ({}), expected percussive drilling",
                                              analysis.segments.front().reason));
  analysis.built = build_bank(analysis.segments, options.method, options.clicks, title(part));
  analysis.built.bank.name = part.bank;
  return analysis;
}

}  // namespace rigsound::analysis
