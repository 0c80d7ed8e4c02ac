#include "clicks/best_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clicks/gaps.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kMissCost = 2, kDoubleCost = 4, kPauseCost = 6 * kMissCost;
constexpr double kLongestGap = 4.5;  // periods
constexpr double kLongestEdge = 3;   // periods of silence that cost
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
    while (j > before.first && after_gap(total_.data(), i, j) != total) --j;
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

double least_total(const std::vector<double>& score) {
  constexpr double kDearestEdge = kLongestEdge * kMissCost;
  return *std::max_element(score.begin(), score.end()) - kDearestEdge - kDearestEdge;
}

}  // namespace rigsound::analysis
