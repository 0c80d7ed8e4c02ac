#include "rigsound/analysis/chain.hpp"

#include <fmt/format.h>

#include <mutex>

#include "chain/clip_analysis.hpp"
#include "chain/segments.hpp"
#include "chain/verdict_windows.hpp"
#include "rigsound/analysis/parallel.hpp"

namespace rigsound::analysis {
namespace {

using KeepSound = std::function<Samples(const Samples& sound)>;

std::vector<ChainResult> analyse_segments(const std::vector<Segment>& segments, const Samples& mono,
                                          const KeepSound& keep, const ChainOptions& options) {
  const std::vector<std::vector<Segment>> windows =
      windows_by_segment(plan_windows(static_cast<long>(mono.size())), segments);
  const int count = static_cast<int>(segments.size());
  std::vector<ChainResult> results(segments.size());
  std::mutex reporting;
  int done = 0;
  for_each_index(count, options.jobs, [&](int k) {
    ChainOptions own = options;
    if (count > 1 && !own.dump.empty()) own.dump /= fmt::format("segment_{:03}", k);
    results[k] = analyse_clip(
        mono.piece(static_cast<std::size_t>(segments[k].begin), static_cast<std::size_t>(segments[k].end)),
        windows[k], own);
    results[k].drilling = keep(results[k].drilling);
    const std::lock_guard lock(reporting);
    ++done;
    if (options.progress) options.progress(done, count);
  });
  if (options.labelled) trust_the_label(results);
  return results;
}

}  // namespace

SegmentedResult run_chain_in_segments(const Samples& mono, SampleFile& file, const ChainOptions& options) {
  const std::vector<Segment> segments = plan_segments(static_cast<long>(mono.size()));
  const auto keep = [&file](const Samples& sound) { return file.keep(sound.all()); };
  return join_segments(segments, analyse_segments(segments, mono, keep, options));
}

SegmentedResult run_chain_in_memory(const Samples& mono, const ChainOptions& options) {
  const std::vector<Segment> segments = plan_segments(static_cast<long>(mono.size()));
  const auto keep = [](const Samples& sound) { return sound; };
  const std::vector<ChainResult> results = analyse_segments(segments, mono, keep, options);
  SegmentedResult result = join_segments(segments, results);
  result.joined.drilling = join_drilling(segments, results);
  return result;
}

ChainResult run_chain(const Samples& mono, const ChainOptions& options) {
  return run_chain_in_memory(mono, options).joined;
}

}  // namespace rigsound::analysis
