#include "rigsound/analysis/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <utility>

#include "chain/clip_analysis.hpp"
#include "chain/clip_neighbours.hpp"
#include "chain/machines.hpp"
#include "chain/segments.hpp"
#include "chain/verdict_windows.hpp"
#include "rigsound/analysis/parallel.hpp"

namespace rigsound::analysis {
namespace {

using KeepSound = std::function<Samples(const Samples& sound)>;

std::vector<MachineResults> analyse_segments(const std::vector<Segment>& segments, const Samples& mono,
                                             const KeepSound& keep, const ChainOptions& options) {
  const std::vector<std::vector<Segment>> windows =
      windows_by_segment(plan_windows(static_cast<long>(mono.size())), segments);
  const int count = static_cast<int>(segments.size());
  std::vector<std::vector<ChainResult>> results(segments.size());
  std::mutex reporting;
  int done = 0;
  for_each_index(count, options.jobs, [&](int k) {
    ChainOptions own = options;
    if (count > 1 && !own.dump.empty()) own.dump /= fmt::format("segment_{:03}", k);
    results[k] = analyse_clip(
        mono.piece(static_cast<std::size_t>(segments[k].begin), static_cast<std::size_t>(segments[k].end)),
        windows[k], own);
    for (ChainResult& machine : results[k]) machine.drilling = keep(machine.drilling);
    const std::lock_guard lock(reporting);
    ++done;
    if (options.progress) options.progress(done, count);
  });
  if (!options.labelled) decide_beside_neighbours(results);
  std::vector<MachineResults> machines = by_machine(std::move(results));
  if (options.labelled)
    for (MachineResults& machine : machines) trust_the_label(machine);
  return machines;
}

std::vector<SegmentedResult> join_each(const std::vector<Segment>& segments,
                                       const std::vector<MachineResults>& machines) {
  std::vector<SegmentedResult> joined;
  std::vector<Machine> figures;
  for (const MachineResults& machine : machines) joined.push_back(join_segments(segments, machine));
  for (const SegmentedResult& machine : joined)
    if (machine.joined.drilling_found)
      figures.push_back(machine_figures(machine, static_cast<std::size_t>(segments.back().end)));
  for (SegmentedResult& machine : joined) machine.joined.machines = figures;
  return joined;
}

/// Whoever asks for a machine that is not there is told which ones are.
SegmentedResult no_such_machine(const std::vector<SegmentedResult>& machines, int wanted) {
  SegmentedResult none;
  none.segments = machines.front().segments;
  none.joined = machines.front().joined;
  none.joined.clicks = {};
  if (none.joined.drilling_found)
    none.joined.reason = fmt::format("there is no machine {}, only one of {:.1f} clicks a second", wanted,
                                     none.joined.machines.front().rate_hz);
  none.joined.drilling_found = false;
  return none;
}

bool is_there(const std::vector<SegmentedResult>& machines, int wanted) {
  return static_cast<std::size_t>(wanted) <= machines.size();
}

}  // namespace

SegmentedResult run_chain_in_segments(const Samples& mono, SampleFile& file, const ChainOptions& options) {
  const std::vector<Segment> segments = plan_segments(static_cast<long>(mono.size()));
  const auto keep = [&file](const Samples& sound) { return file.keep(sound.all()); };
  std::vector<SegmentedResult> machines =
      join_each(segments, analyse_segments(segments, mono, keep, options));
  const int wanted = std::max(1, options.machine);
  return is_there(machines, wanted) ? std::move(machines[static_cast<std::size_t>(wanted - 1)])
                                    : no_such_machine(machines, wanted);
}

SegmentedResult run_chain_in_memory(const Samples& mono, const ChainOptions& options) {
  const std::vector<Segment> segments = plan_segments(static_cast<long>(mono.size()));
  const auto keep = [](const Samples& sound) { return sound; };
  const std::vector<MachineResults> results = analyse_segments(segments, mono, keep, options);
  std::vector<SegmentedResult> machines = join_each(segments, results);
  if (!is_there(machines, options.machine)) {
    SegmentedResult none = no_such_machine(machines, options.machine);
    none.joined.drilling = std::vector<float>(mono.size());
    return none;
  }
  const auto meant = static_cast<std::size_t>(std::max(1, options.machine) - 1);
  SegmentedResult result = machines[meant];
  std::vector<float> sound = join_drilling(segments, results[meant]);
  if (options.machine == 0 && machines.size() > 1) {
    result.joined = together(machines);
    for (std::size_t m = 1; m < machines.size(); ++m) {
      const std::vector<float> other = join_drilling(segments, results[m]);
      std::transform(sound.begin(), sound.end(), other.begin(), sound.begin(), std::plus<>());
    }
  }
  result.joined.drilling = std::move(sound);
  return result;
}

ChainResult run_chain(const Samples& mono, const ChainOptions& options) {
  return run_chain_in_memory(mono, options).joined;
}

}  // namespace rigsound::analysis
