#include "clicks/onset_owners.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kNormalMad = 1.48;  // standard deviation of a normal distribution over its median deviation
constexpr double kLeastScatter = 0.02, kMostScatter = 0.2;
constexpr double kOutlier = 18, kMissed = 2, kPause = 12, kNobodys = 7;  // nats
constexpr std::size_t kFollowed = 32;

using LastOnsets = std::array<int, 2>;  // indices, -1: none yet

/// A division up to some onset: its cost, and how it came about.
struct Division {
  double cost;
  LastOnsets before;
  int owner;
};
using Divisions = std::map<LastOnsets, Division>;

double cost_of_gap(double gap, const GapFigures& machine) {
  const double periods = gap / machine.period, n = std::max(1.0, std::round(periods));
  const double z = (periods - n) / (machine.scatter * std::sqrt(n));
  return std::min(z * z / 2, kOutlier) + std::min(kMissed * (n - 1), kPause) + std::log(machine.scatter);
}

void offer(const LastOnsets& last, const Division& division, Divisions& divisions) {
  const auto [known, is_new] = divisions.emplace(last, division);
  if (!is_new && division.cost < known->second.cost) known->second = division;
}

void keep_cheapest(Divisions& divisions) {
  if (divisions.size() <= kFollowed) return;
  std::vector<double> cost;
  for (const auto& [last, division] : divisions) cost.push_back(division.cost);
  std::nth_element(cost.begin(), cost.begin() + kFollowed, cost.end());
  for (auto it = divisions.begin(); it != divisions.end();)
    it = it->second.cost >= cost[kFollowed] ? divisions.erase(it) : std::next(it);
}

Divisions with_onset(int i, const std::vector<int>& onsets, const std::array<GapFigures, 2>& machines,
                     const Divisions& before) {
  Divisions after;
  for (const auto& [last, division] : before) {
    offer(last, {division.cost + kNobodys, last, kNobody}, after);
    for (int k = 0; k < 2; ++k) {
      LastOnsets now = last;
      now[k] = i;
      const double gap = last[k] < 0 ? 0 : cost_of_gap(onsets[i] - onsets[last[k]], machines[k]);
      offer(now, {division.cost + gap, last, k}, after);
    }
  }
  keep_cheapest(after);
  return after;
}

}  // namespace

GapFigures gap_figures(const std::vector<int>& onsets) {
  const double period = median_gap(onsets);
  std::vector<double> deviation;
  for (std::size_t i = 1; i < onsets.size(); ++i)
    deviation.push_back(std::fabs((onsets[i] - onsets[i - 1]) / period - 1));
  return {period, std::clamp(kNormalMad * median(std::move(deviation)), kLeastScatter, kMostScatter)};
}

std::vector<int> owners(const std::vector<int>& onsets, const std::array<GapFigures, 2>& machines) {
  std::vector<Divisions> at{{{LastOnsets{-1, -1}, {0, {}, kNobody}}}};
  for (int i = 0; i < static_cast<int>(onsets.size()); ++i)
    at.push_back(with_onset(i, onsets, machines, at.back()));
  const auto cheaper = [](const auto& a, const auto& b) { return a.second.cost < b.second.cost; };
  LastOnsets last = std::min_element(at.back().begin(), at.back().end(), cheaper)->first;
  std::vector<int> owner(onsets.size());
  for (std::size_t i = onsets.size(); i-- > 0;) {
    const Division& division = at[i + 1].at(last);
    owner[i] = division.owner;
    last = division.before;
  }
  return owner;
}

}  // namespace rigsound::analysis
