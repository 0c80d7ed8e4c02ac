#include "tool_fit/steel_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/nelder_mead.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kNear_cents = 20, kMatch_cents = 12;
constexpr double kMostChance = 0.01;  // that some size would match partials of anything as well
constexpr double kShortest_m = 0.25, kLongest_m = 1.1, kThinnest_m = 0.012, kThickest_m = 0.06;

double cents_to_nearest(const std::vector<double>& modes, double hz) {
  const auto above = std::lower_bound(modes.begin(), modes.end(), hz);
  double nearest = 1e9;
  if (above != modes.end()) nearest = 1200 * std::log2(*above / hz);
  if (above != modes.begin()) nearest = std::min(nearest, 1200 * std::log2(hz / *(above - 1)));
  return nearest;
}

class Search {
 public:
  Search(const std::vector<Partial>& partials, double highest_hz)
      : partials_(partials), highest_hz_(highest_hz) {}

  /// How much better the partials fit the bar than they would by chance. Every mode makes a match by chance
  /// likelier.
  double score(const Bar& bar) const {
    const std::vector<double> modes = modes_below(bar, highest_hz_);
    if (modes.empty()) return -1e9;
    double sum = 0;
    for (const Partial& p : partials_) {
      const double miss = cents_to_nearest(modes, p.hz) / kNear_cents;
      sum += std::sqrt(p.prominence_db) * (std::exp(-0.5 * miss * miss) - chance(modes, p.hz));
    }
    return sum;
  }

  int matched(const Bar& bar) const {
    const std::vector<double> modes = modes_below(bar, highest_hz_);
    int count = 0;
    for (const Partial& p : partials_) count += cents_to_nearest(modes, p.hz) <= kMatch_cents;
    return count;
  }

  /// Probability that `matched` or more partials that lie anywhere match modes as dense as those of the bar.
  double by_chance(const Bar& bar, int matched) const {
    const std::vector<double> modes = modes_below(bar, highest_hz_);
    std::vector<double> of_count(partials_.size() + 1, 0.0);
    of_count[0] = 1;
    for (const Partial& p : partials_) {
      const double one = std::min(1.0, modes_around(modes, p.hz) * 2 * kMatch_cents / 1200);
      for (std::size_t k = partials_.size(); k > 0; --k)
        of_count[k] = (1 - one) * of_count[k] + one * of_count[k - 1];
      of_count[0] *= 1 - one;
    }
    return std::accumulate(of_count.begin() + matched, of_count.end(), 0.0);
  }

 private:
  /// Within the octave around hz.
  static double modes_around(const std::vector<double>& modes, double hz) {
    return static_cast<double>(std::upper_bound(modes.begin(), modes.end(), hz * 1.414) -
                               std::lower_bound(modes.begin(), modes.end(), hz / 1.414));
  }

  /// Expected value of the Gaussian above if the partial lay anywhere within an octave.
  static double chance(const std::vector<double>& modes, double hz) {
    return std::min(1.0, modes_around(modes, hz) * 2.5 * kNear_cents / 1200);
  }

  const std::vector<Partial>& partials_;
  double highest_hz_;
};

std::vector<double> geometric(double given, double low, double high, double ratio) {
  if (given > 0) return {given};
  std::vector<double> values;
  for (double v = low; v <= high; v *= ratio) values.push_back(v);
  return values;
}

/// Sizes so far apart that the modes of one match none of another.
double sizes_tried(const Bar& given) {
  const auto count = [](double known, double low, double high) {
    return known > 0 ? 1 : std::log2(high / low) * 1200 / (2 * kMatch_cents);
  };
  return count(given.length_m, kShortest_m, kLongest_m) * count(given.diameter_m, kThinnest_m, kThickest_m);
}

Bar refined(const Search& search, const Bar& start, const Bar& given) {
  const auto bar_at = [&](const std::vector<double>& u) {
    return Bar{given.length_m > 0 ? given.length_m : std::exp(u[0]),
               given.diameter_m > 0 ? given.diameter_m : std::exp(u[1])};
  };
  const std::vector<double> from = {std::log(start.length_m), std::log(start.diameter_m)};
  const SimplexOptions options{
      {0.003, 0.006}, {1e-6, 1e-6}, {from[0] - 0.02, from[1] - 0.03}, {from[0] + 0.02, from[1] + 0.03}, 200};
  return bar_at(
      nelder_mead([&](const std::vector<double>& u) { return -search.score(bar_at(u)); }, from, options));
}

}  // namespace

std::optional<FoundSteel> find_steel(const std::vector<Partial>& partials, const Bar& given,
                                     double highest_hz) {
  if (partials.size() < 4) return std::nullopt;
  const Search search(partials, highest_hz);
  Bar best{0.5, 0.025};
  double best_score = -1e18;
  for (const double length : geometric(given.length_m, kShortest_m, kLongest_m, 1.006))
    for (const double diameter : geometric(given.diameter_m, kThinnest_m, kThickest_m, 1.012)) {
      if (diameter > length / 4) continue;
      const double score = search.score({length, diameter});
      if (score > best_score) best_score = score, best = {length, diameter};
    }
  best = refined(search, best, given);
  const int matched = search.matched(best);
  const double by_chance = search.by_chance(best, matched) * sizes_tried(given);
  if (matched < 4 || matched < static_cast<int>(partials.size()) / 2 || by_chance > kMostChance)
    return std::nullopt;
  return FoundSteel{best, matched};
}

}  // namespace rigsound::analysis
