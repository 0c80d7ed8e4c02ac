#include "rigsound/analysis/chain.hpp"

#include <fmt/format.h>

#include <mutex>

#include "chain/clip_analysis.hpp"
#include "chain/segments.hpp"
#include "chain/verdict_windows.hpp"
#include "rigsound/analysis/parallel.hpp"

namespace rigsound::analysis {

SegmentedResult run_chain_in_segments(const std::vector<float>& mono, const ChainOptions& options) {
  const std::vector<Segment> segments = plan_segments(static_cast<long>(mono.size()));
  const std::vector<std::vector<Segment>> windows =
      windows_by_segment(plan_windows(static_cast<long>(mono.size())), segments);
  const int count = static_cast<int>(segments.size());
  std::vector<ChainResult> results(segments.size());
  std::mutex reporting;
  int done = 0;
  for_each_index(count, options.jobs, [&](int k) {
    ChainOptions own = options;
    if (count > 1 && !own.dump.empty()) own.dump /= fmt::format("segment_{:03}", k);
    results[k] =
        analyse_clip({mono.begin() + segments[k].begin, mono.begin() + segments[k].end}, windows[k], own);
    const std::lock_guard lock(reporting);
    ++done;
    if (options.progress) options.progress(done, count);
  });
  if (options.labelled) trust_the_label(results);
  return join_segments(segments, std::move(results));
}

ChainResult run_chain(const std::vector<float>& mono, const ChainOptions& options) {
  return run_chain_in_segments(mono, options).joined;
}

}  // namespace rigsound::analysis
