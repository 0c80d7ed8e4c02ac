#include "analyzer/part_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bank/segment.hpp"
#include "rigsound/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLongestSegment_s = 4, kLongestPaperSegment_s = 2;
constexpr double kLabelSlack_s = 0.05;  // labels are set by hand

std::string title(const Part& part) {
  if (part.whole) return part.recording.string();
  return fmt::format("{} [{:.3f}-{:.3f} s]", part.recording.string(), part.label.start_s, part.label.end_s);
}

std::vector<float> cut(const Part& part, const std::vector<float>& mono) {
  if (part.whole) return mono;
  const double duration = static_cast<double>(mono.size()) / kAnalysisRate;
  if (part.label.end_s > duration + kLabelSlack_s)
    throw InputError(
        part.recording.string(),
        fmt::format("the label of line {} ends at {} s, expected at most the recording's end at {:.3f} s",
                    part.label.line, part.label.end_s, duration));
  const auto frame = [&](double s) {
    return std::min(static_cast<long>(std::llround(s * kAnalysisRate)), static_cast<long>(mono.size()));
  };
  const long from = frame(part.label.start_s), to = frame(part.label.end_s);
  if (static_cast<double>(to - from) < kMinRecordingSeconds * kAnalysisRate)
    throw InputError(title(part), fmt::format("is too short, expected {} s or more", kMinRecordingSeconds));
  return {mono.begin() + from, mono.begin() + to};
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

PartAnalysis analyse_part(const Part& part, const Recording& recording, const AnalyzerOptions& options) {
  PartAnalysis analysis;
  const bool paper = options.method == Method::kPaper;
  analysis.recorded =
      segments_of(cut(part, recording.mono), paper ? kLongestPaperSegment_s : kLongestSegment_s);
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
