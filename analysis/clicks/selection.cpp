#include "clicks/selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kBlockRate = kAnalysisRate / kCandidateBlock;
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

/// What chance alone gives: the total of the best chain through the candidates at random times. Where
/// is_enough(chance) of what is already known to be given, no more is drawn than for that.
template <class IsEnough>
double total_by_chance(const std::vector<std::vector<int>>& draws, const std::vector<double>& score,
                       const GapCosts& costs, long length, const IsEnough& is_enough) {
  const double least = least_total(score);
  double sum = 0;
  for (std::size_t drawn = 0; drawn < draws.size(); ++drawn) {
    sum += best_chain(draws[drawn], score, costs, length).total;
    double at_least = sum;
    for (std::size_t rest = drawn + 1; rest < draws.size(); ++rest) at_least += least;
    if (is_enough(at_least / kChanceDraws)) return at_least / kChanceDraws;
  }
  return sum / kChanceDraws;
}

bool never(double) { return false; }

std::vector<int> blocks_of(const Candidates& candidates, const Chain& chain) {
  std::vector<int> blocks;
  for (const int i : chain.chosen) blocks.push_back(candidates.block[i]);
  return blocks;
}

struct Hypothesis {
  GapCosts costs;  ///< of its period
  Chain chain;
};

/// The best chain through the candidates by period, blocks: most hypotheses are refined to few periods.
class ChainsByPeriod {
 public:
  ChainsByPeriod(const Candidates& candidates, const std::vector<double>& score)
      : candidates_(candidates), score_(score) {}

  const Chain& of(const GapCosts& costs) {
    return found(costs.T_0, [&] { return through(costs); });
  }
  const Chain& of(double period) {
    return found(period, [&] { return through(GapCosts(period)); });
  }

 private:
  Chain through(const GapCosts& costs) const {
    return best_chain(candidates_.block, score_, costs, candidates_.z.size());
  }

  template <class Search>
  const Chain& found(double period, const Search& search) {
    const auto known = chains_.find(period);
    return known != chains_.end() ? known->second : chains_.emplace(period, search()).first->second;
  }

  const Candidates& candidates_;
  const std::vector<double>& score_;
  std::map<double, Chain> chains_;
};

/// The best chain of period T, refined by its own gaps.
Hypothesis best_near(int T, const Candidates& candidates, ChainsByPeriod& chains) {
  Hypothesis h{GapCosts(T), {}};
  h.chain = chains.of(h.costs);
  if (h.chain.chosen.size() <= 3) return h;
  const double refined = median_gap(blocks_of(candidates, h.chain));
  if (std::fabs(refined / T - 1) < 0.35) h.chain = chains.of(refined);
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

Selection select_at_period(const Candidates& candidates, double T_0) {
  Selection selection;
  selection.mean_gap_blocks = T_0;
  if (candidates.block.empty()) return selection;
  const std::vector<double> score = scores(candidates, reference_statistic(candidates));
  const GapCosts costs(T_0);
  const Chain chain = best_chain(candidates.block, score, costs, candidates.z.size());
  selection.total = chain.total;
  selection.surplus = chain.total - total_by_chance(random_times(score.size(), candidates.z.size()), score,
                                                    costs, candidates.z.size(), never);
  selection.block = blocks_of(candidates, chain);
  return selection;
}

Selection select_clicks(const Candidates& candidates, const RateRange& range) {
  Selection selection;
  if (candidates.block.size() < 4) return selection;
  const double reference = reference_statistic(candidates);
  const std::vector<double> score = scores(candidates, reference);
  const std::vector<std::vector<int>> draws = random_times(score.size(), candidates.z.size());
  ChainsByPeriod chains(candidates, score);
  std::vector<Hypothesis> hypotheses;
  for (const int T : period_hypotheses(candidates.z.min(reference), kBlockRate, range))
    hypotheses.push_back(best_near(T, candidates, chains));
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.chain.total > b.chain.total; });
  const double least_chance = least_total(score);
  double best = -std::numeric_limits<double>::infinity();
  const auto take = [&](const Hypothesis& h, double chance) {
    selection.surplus = h.chain.total - chance;
    selection.total = h.chain.total;
    selection.block = blocks_of(candidates, h.chain);
    selection.mean_gap_blocks = selection.block.size() > 2 ? median_gap(selection.block) : h.costs.T_0;
  };
  for (const Hypothesis& h : hypotheses) {
    const auto loses = [&](double chance) { return h.chain.total - kChanceShare * chance <= best; };
    if (loses(least_chance)) break;  // so does all that follows
    const double chance = total_by_chance(draws, score, h.costs, candidates.z.size(), loses);
    if (loses(chance)) continue;
    best = h.chain.total - kChanceShare * chance;
    take(h, chance);
  }
  const double pairs = period_of_pairs(selection.block);
  if (pairs > 0 && kBlockRate / pairs >= range.slowest_hz) {
    const Hypothesis h = best_near(static_cast<int>(std::lround(pairs)), candidates, chains);
    take(h, total_by_chance(draws, score, h.costs, candidates.z.size(), never));
  }
  return selection;
}

}  // namespace rigsound::analysis
