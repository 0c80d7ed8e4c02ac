#include "analyzer/part_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bank/segment.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLongestSegment_s = 4, kLongestPaperSegment_s = 2;
constexpr double kDrillingShare = 0.2;  // of the segments of a part

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

/// One segment in many may strike by chance: music does, and speech.
void require_drilling(const std::string& title, const std::vector<ChainResult>& segments) {
  const auto drilling = std::count_if(segments.begin(), segments.end(), has_drilling);
  if (drilling == 0)
    throw InputError(
        title, fmt::format("no drilling found ({}), expected percussive drilling", segments.front().reason));
  if (static_cast<double>(drilling) < kDrillingShare * static_cast<double>(segments.size()))
    throw InputError(title,
                     fmt::format("no drilling found but in {} of {} segments, expected a fifth of them: "
                                 "label the stretch that drills",
                                 drilling, segments.size()));
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
  require_drilling(title(part), analysis.segments);
  analysis.built = build_bank(analysis.segments, options.method, options.clicks, title(part));
  analysis.built.bank.name = part.bank;
  return analysis;
}

}  // namespace rigsound::analysis
