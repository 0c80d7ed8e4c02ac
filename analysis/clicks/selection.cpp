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

/// Candidates that a gap to the one at hand may follow, and the best of those that only a pause follows, -1
/// for none.
struct Predecessors {
  int first, last, pause;
};

/// The best chains that end at each candidate, one after the other.
class ChainEnds {
 public:
  ChainEnds(const std::vector<int>& time, const std::vector<double>& score, const GapCosts& costs)
      : time_(time.data()), score_(score.data()), costs_(costs) {
    total_.reserve(time.size()), best_so_far_.reserve(time.size()), before_.reserve(time.size());
  }

  double total(int i) const { return total_[static_cast<std::size_t>(i)]; }

  void add(const Predecessors& before) {
    const double total = best_total(static_cast<int>(total_.size()), before);
    best_so_far_.push_back(total_.empty() ? total : std::max(best_so_far_.back(), total));
    total_.push_back(total);
    before_.push_back(before);
  }

  /// -1 for none. Of equals the latest that a gap follows is last.
  int predecessor(int i) const {
    const Predecessors& before = before_[static_cast<std::size_t>(i)];
    const double total = this->total(i);
    if (total == alone(i)) return -1;
    if (before.pause >= 0 && total == after_pause(i, before.pause)) return before.pause;
    int j = before.last;
    while (after_gap(total_.data(), i, j) != total) --j;
    return j;
  }

 private:
  /// By value: std::max() of what is computed becomes a jump.
  static double most(double a, double b) { return a > b ? a : b; }

  double alone(int i) const { return score_[i] - edge_cost(time_[i], costs_.T_0); }
  double after_pause(int i, int j) const { return total(j) + score_[i] - kPauseCost; }
  double after_gap(const double* total, int i, int j) const {
    return total[j] + score_[i] - costs_.of_gap[static_cast<std::size_t>(time_[i] - time_[j])];
  }

  /// No gap costs less than nothing: where the best total up to j would not do, none before it does. Four at
  /// a time, and without asking which it is: no processor foretells what improves.
  double best_total(int i, const Predecessors& before) const {
    const double *total = total_.data(), *best_so_far = best_so_far_.data();
    const double score = score_[i];
    double best = alone(i);
    if (before.pause >= 0) best = most(best, after_pause(i, before.pause));
    int j = before.last;
    for (; j - 3 >= before.first && best_so_far[j] + score > best; j -= 4)
      best = most(best, most(most(after_gap(total, i, j), after_gap(total, i, j - 1)),
                             most(after_gap(total, i, j - 2), after_gap(total, i, j - 3))));
    for (; j >= before.first && best_so_far[j] + score > best; --j) best = most(best, after_gap(total, i, j));
    return best;
  }

  const int* time_;
  const double* score_;
  const GapCosts& costs_;
  std::vector<double> total_, best_so_far_;
  std::vector<Predecessors> before_;
};

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

/// Of no best chain is the total less: that of the highest candidate alone.
double least_total(const std::vector<double>& score) {
  constexpr double kDearestEdge = kLongestEdge * kMissCost;
  return *std::max_element(score.begin(), score.end()) - kDearestEdge - kDearestEdge;
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

double gap_cost(double g) {
  if (g < kShortestGap || g > kLongestGap) return kInfinite;
  const double ln_g = std::log(g);
  double cost = deviation_cost(ln_g, 0.2);
  for (int k = 2; k <= 4 && cost > kMissCost * (k - 1); ++k)
    cost = std::min(cost, kMissCost * (k - 1) + deviation_cost(ln_g - kLn[k], 0.16));
  return g < kDoubleBelow ? std::min(cost, kDoubleCost) : cost;
}

GapCosts::GapCosts(double period) : T_0(period) {
  for (int gap = 0; gap / T_0 <= kLongestGap; ++gap) of_gap.push_back(gap_cost(gap / T_0));
}

Chain best_chain(const std::vector<int>& time, const std::vector<double>& score, const GapCosts& costs,
                 long length) {
  const double T_0 = costs.T_0;
  const long shortest =
      std::find_if(costs.of_gap.begin(), costs.of_gap.end(), [](double cost) { return cost < kInfinite; }) -
      costs.of_gap.begin();
  ChainEnds ends(time, score, costs);
  Predecessors before{0, -1, -1};
  int best = -1;
  double best_total = -kInfinite;
  for (int i = 0; i < static_cast<int>(time.size()); ++i) {
    for (; time[i] - time[before.first] > kLongestGap * T_0; ++before.first)
      if (before.pause < 0 || ends.total(before.first) > ends.total(before.pause))
        before.pause = before.first;
    while (before.last + 1 < i && time[i] - time[before.last + 1] >= shortest) ++before.last;
    ends.add(before);
    const double total = ends.total(i) - edge_cost(static_cast<double>(length - time[i]), T_0);
    if (total > best_total) best_total = total, best = i;
  }
  Chain chain;
  chain.total = best_total;
  for (int i = best; i >= 0; i = ends.predecessor(i)) chain.chosen.push_back(i);
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
  double best = -kInfinite;
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
