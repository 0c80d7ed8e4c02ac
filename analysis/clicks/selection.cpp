#include "clicks/selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kBlockRate = kAnalysisRate / kCandidateBlock;
constexpr double kMissCost = 2, kDoubleCost = 4, kPauseCost = 6 * kMissCost;
constexpr double kLongestGap = 4.5;  // periods
constexpr double kLongestEdge = 3;   // periods of silence that cost
// The k-th highest candidate sets the scale, k = 5 a second; where the 2.5 highest a second stand far above
// it, impacts are slower than that, and it is noise.
constexpr double kReferenceRate_hz = 5, kSlowReferenceRate_hz = 2.5, kFarAbove = 1.6;
constexpr double kScoreAtReference = 8.4, kScoreCap = 12;
// Not all of what chance gives: it has many candidates a long period to choose from, of which impacts that
// are there leave it few, and slow drills would be found at half their period.
constexpr double kChanceShare = 0.5;
constexpr int kChanceDraws = 6;
// Strikes that come in pairs: what a long gap measures of a short one, how far their sums may differ, and the
// share of the chain that must be so. Of swung music the long gap measures two short ones.
constexpr double kRest = 2.5, kPairsApart = 0.15, kMostInPairs = 0.75;
constexpr double kLn[] = {0, 0, 0.69314718055994531, 1.0986122886681098, 1.3862943611198906};  // of 2, 3, 4
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Robust squared deviation of ln g from ln of a whole number of periods.
double deviation_cost(double ln_ratio, double width) {
  const double x = ln_ratio / width;
  return 1.5 * x * x / (1 + 0.15 * x * x);
}

double edge_cost(double silence, double T_0) { return kMissCost * std::min(kLongestEdge, silence / T_0); }

struct Step {
  double total;
  int previous;
  double best_so_far = 0;  ///< of the totals up to here
};

/// The best chain that ends at candidate i, given those before it. `pause`: the best that ended over
/// kLongestGap ago, -1 for none. No gap costs less than nothing: where the best total up to j would not do,
/// none before it does.
Step best_step(const std::vector<int>& time, const std::vector<Step>& steps, int i, int pause, double score,
               const GapCosts& costs) {
  Step best{score - edge_cost(time[i], costs.T_0), -1};
  if (pause >= 0 && steps[pause].total + score - kPauseCost > best.total)
    best = {steps[pause].total + score - kPauseCost, pause};
  const auto longest = static_cast<int>(costs.of_gap.size());
  for (int j = i - 1; j >= 0 && time[i] - time[j] < longest && steps[j].best_so_far + score > best.total;
       --j) {
    const double total = steps[j].total + score - costs.of_gap[time[i] - time[j]];
    if (total > best.total) best = {total, j};
  }
  return best;
}

/// Scores: the statistic scaled so that the reference candidate of every recording weighs the same, less a
/// threshold that is higher where other candidates are clear.
std::vector<double> scores(const Candidates& candidates, double reference) {
  const double threshold = std::clamp(0.27 * reference, 1.2, 3.0),
               scale = std::min(1.0, kScoreAtReference / reference);
  std::vector<double> score;
  for (const int block : candidates.block)
    score.push_back(std::min(candidates.z(block) * scale, kScoreCap) - threshold);
  return score;
}

double reference_statistic(const Candidates& candidates) {
  std::vector<double> z;
  for (const int block : candidates.block) z.push_back(candidates.z(block));
  std::sort(z.begin(), z.end(), std::greater<>());
  const double seconds = static_cast<double>(candidates.z.size()) / kBlockRate;
  const auto highest = [&](double rate_hz) {
    const long k = std::max(2L, static_cast<long>(rate_hz * seconds));
    return z[std::min(static_cast<size_t>(k), z.size()) - 1];
  };
  const double usual = highest(kReferenceRate_hz), slow = highest(kSlowReferenceRate_hz);
  return slow > kFarAbove * usual ? slow : usual;
}

/// `count` random times within `length`, ascending, for every draw; always the same.
std::vector<std::vector<int>> random_times(size_t count, long length) {
  std::mt19937_64 bits;
  std::vector<std::vector<int>> draws(kChanceDraws, std::vector<int>(count));
  for (std::vector<int>& time : draws) {
    for (int& at : time) at = static_cast<int>(bits() % static_cast<unsigned long>(length));
    std::sort(time.begin(), time.end());
  }
  return draws;
}

/// What chance alone gives: the total of the best chain through the candidates at random times.
double total_by_chance(const std::vector<std::vector<int>>& draws, const std::vector<double>& score,
                       const GapCosts& costs, long length) {
  double sum = 0;
  for (const std::vector<int>& time : draws) sum += best_chain(time, score, costs, length).total;
  return sum / kChanceDraws;
}

std::vector<int> blocks_of(const Candidates& candidates, const Chain& chain) {
  std::vector<int> blocks;
  for (const int i : chain.chosen) blocks.push_back(candidates.block[i]);
  return blocks;
}

struct Hypothesis {
  GapCosts costs;  ///< of its period
  Chain chain;
};

/// The best chain of period T, refined by its own gaps.
Hypothesis best_near(int T, const Candidates& candidates, const std::vector<double>& score) {
  Hypothesis h{GapCosts(T), {}};
  h.chain = best_chain(candidates.block, score, h.costs, candidates.z.size());
  if (h.chain.chosen.size() <= 3) return h;
  const double refined = median_gap(blocks_of(candidates, h.chain));
  if (std::fabs(refined / T - 1) < 0.35)
    h.chain = best_chain(candidates.block, score, GapCosts(refined), candidates.z.size());
  return h;
}

/// The period of a chain that rests after every second click, blocks: one hears strikes that come twice,
/// found as pulses of which some are missed. 0 for other chains.
double period_of_pairs(const std::vector<int>& block) {
  std::vector<double> sums;
  for (std::size_t i = 2; i < block.size(); ++i) {
    const double before = block[i - 1] - block[i - 2], after = block[i] - block[i - 1];
    if (std::max(before, after) >= kRest * std::min(before, after)) sums.push_back(before + after);
  }
  if (sums.size() < 4 || static_cast<double>(sums.size()) < kMostInPairs * static_cast<double>(block.size()))
    return 0;
  const double period = upper_median(sums);
  const auto steady = std::count_if(sums.begin(), sums.end(),
                                    [&](double sum) { return std::fabs(sum / period - 1) < kPairsApart; });
  return static_cast<double>(steady) < kMostInPairs * static_cast<double>(sums.size()) ? 0 : period;
}

}  // namespace

double gap_cost(double g) {
  if (g < kShortestGap || g > kLongestGap) return kInfinite;
  const double ln_g = std::log(g);
  double cost = deviation_cost(ln_g, 0.2);
  for (int k = 2; k <= 4; ++k)
    cost = std::min(cost, kMissCost * (k - 1) + deviation_cost(ln_g - kLn[k], 0.16));
  return g < kDoubleBelow ? std::min(cost, kDoubleCost) : cost;
}

GapCosts::GapCosts(double period) : T_0(period) {
  for (int gap = 0; gap / T_0 <= kLongestGap; ++gap) of_gap.push_back(gap_cost(gap / T_0));
}

Chain best_chain(const std::vector<int>& time, const std::vector<double>& score, const GapCosts& costs,
                 long length) {
  const double T_0 = costs.T_0;
  std::vector<Step> steps;
  int best = -1, pause = -1, waiting = 0;
  double best_total = -kInfinite;
  for (int i = 0; i < static_cast<int>(time.size()); ++i) {
    for (; time[i] - time[waiting] > kLongestGap * T_0; ++waiting)
      if (pause < 0 || steps[waiting].total > steps[pause].total) pause = waiting;
    Step step = best_step(time, steps, i, pause, score[i], costs);
    step.best_so_far = i > 0 ? std::max(steps[i - 1].best_so_far, step.total) : step.total;
    steps.push_back(step);
    const double total = steps[i].total - edge_cost(static_cast<double>(length - time[i]), T_0);
    if (total > best_total) best_total = total, best = i;
  }
  Chain chain;
  chain.total = best_total;
  for (int i = best; i >= 0; i = steps[i].previous) chain.chosen.push_back(i);
  std::reverse(chain.chosen.begin(), chain.chosen.end());
  return chain;
}

Selection select_at_period(const Candidates& candidates, double T_0) {
  Selection selection;
  selection.mean_gap_blocks = T_0;
  if (candidates.block.empty()) return selection;
  const std::vector<double> score = scores(candidates, reference_statistic(candidates));
  const GapCosts costs(T_0);
  const Chain chain = best_chain(candidates.block, score, costs, candidates.z.size());
  selection.total = chain.total;
  selection.surplus = chain.total - total_by_chance(random_times(score.size(), candidates.z.size()), score,
                                                    costs, candidates.z.size());
  selection.block = blocks_of(candidates, chain);
  return selection;
}

Selection select_clicks(const Candidates& candidates, const RateRange& range) {
  Selection selection;
  if (candidates.block.size() < 4) return selection;
  const double reference = reference_statistic(candidates);
  const std::vector<double> score = scores(candidates, reference);
  const std::vector<std::vector<int>> draws = random_times(score.size(), candidates.z.size());
  std::vector<Hypothesis> hypotheses;
  for (const int T : period_hypotheses(candidates.z.min(reference), kBlockRate, range))
    hypotheses.push_back(best_near(T, candidates, score));
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.chain.total > b.chain.total; });
  const double least_chance = *std::max_element(score.begin(), score.end()) - 2 * kLongestEdge * kMissCost;
  double best = -kInfinite;
  const auto take = [&](const Hypothesis& h, double chance) {
    selection.surplus = h.chain.total - chance;
    selection.total = h.chain.total;
    selection.block = blocks_of(candidates, h.chain);
    selection.mean_gap_blocks = selection.block.size() > 2 ? median_gap(selection.block) : h.costs.T_0;
  };
  for (const Hypothesis& h : hypotheses) {
    if (h.chain.total - kChanceShare * least_chance <= best) break;  // nor does any that follows exceed it
    const double chance = total_by_chance(draws, score, h.costs, candidates.z.size());
    if (h.chain.total - kChanceShare * chance <= best) continue;
    best = h.chain.total - kChanceShare * chance;
    take(h, chance);
  }
  const double pairs = period_of_pairs(selection.block);
  if (pairs > 0 && kBlockRate / pairs >= range.slowest_hz) {
    const Hypothesis h = best_near(static_cast<int>(std::lround(pairs)), candidates, score);
    take(h, total_by_chance(draws, score, h.costs, candidates.z.size()));
  }
  return selection;
}

}  // namespace rigsound::analysis
