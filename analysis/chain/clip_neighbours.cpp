#include "chain/clip_neighbours.hpp"

#include <algorithm>

#include "chain/verdict_windows.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

/// Of all clips, the likeliest machine of each.
std::vector<VerdictWindow> windows_of(const std::vector<std::vector<ChainResult>>& clips) {
  std::vector<VerdictWindow> windows;
  for (const std::vector<ChainResult>& machines : clips)
    for (std::size_t w = 0; w < machines.front().verdict.size(); ++w) {
      windows.push_back(machines.front().verdict[w]);
      for (const ChainResult& machine : machines)
        windows.back().probability = std::max(windows.back().probability, machine.verdict[w].probability);
    }
  return windows;
}

void keep_between(double begin_s, double end_s, ClickTrain& train) {
  const auto before = [&](double s) {
    return std::lower_bound(train.P.begin(), train.P.end(), s * kAnalysisRate) - train.P.begin();
  };
  const auto first = before(begin_s), last = before(end_s);
  train.P = {train.P.begin() + first, train.P.begin() + last};
  train.beta = {train.beta.begin() + first, train.beta.begin() + last};
}

/// `drills`: each of its windows.
void decide(const std::vector<bool>& drills, ChainResult& clip) {
  const auto first = std::find(drills.begin(), drills.end(), true);
  clip.drilling_found = !clip.clicks.P.empty() && first != drills.end();
  if (!clip.drilling_found) {
    clip.clicks = {};
    return;
  }
  const auto after_last = std::find(drills.rbegin(), drills.rend(), true).base();
  keep_between(clip.verdict[static_cast<std::size_t>(first - drills.begin())].start_s,
               clip.verdict[static_cast<std::size_t>(after_last - drills.begin() - 1)].end_s, clip.clicks);
  clip.reason.clear();
}

}  // namespace

void decide_beside_neighbours(std::vector<std::vector<ChainResult>>& clips) {
  const std::vector<bool> drills = drilling_windows(windows_of(clips));
  auto here = drills.begin();
  for (std::vector<ChainResult>& machines : clips) {
    const auto end = here + static_cast<long>(machines.front().verdict.size());
    for (ChainResult& machine : machines)
      decide(machines.size() == 1 ? std::vector<bool>{here, end} : drilling_windows(machine.verdict),
             machine);
    here = end;
  }
}

}  // namespace rigsound::analysis
