#include "bank/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kShortestPlain = 0.6, kLongestPlain = 1.5;  // of the median: what counts as one plain gap
constexpr double kMostlyDouble = 0.4;       // second strikes a first one: few gaps between all are plain
constexpr double kWholeSlack = 0.25;        // of the median: two parts of one gap add up to it within this
constexpr double kSteadyDeviation = 0.002;  // sigma_T / T_0 below which only rounding is left to correlate
constexpr double kMaxCorrelation = 0.9;

enum class Kind { kPlain, kMissed, kDoubled };

struct SeriesMoments {
  double mean = 0, deviation = 0, correlation = 0;  ///< lag-1, between plain neighbours
};

/// Of the plain values only; `kinds` has the shape of `series`.
SeriesMoments moments(const Series<double>& series, const Series<Kind>& kinds) {
  double count = 0, sum = 0, squares = 0, pairs = 0, products = 0;
  const auto plain = [&](std::size_t s, std::size_t i) { return kinds[s][i] == Kind::kPlain; };
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i < series[s].size(); ++i)
      if (plain(s, i)) sum += series[s][i], ++count;
  const double mean = sum / count;
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i < series[s].size(); ++i) {
      if (!plain(s, i)) continue;
      const double d = series[s][i] - mean;
      squares += d * d;
      if (i + 1 < series[s].size() && plain(s, i + 1)) products += d * (series[s][i + 1] - mean), ++pairs;
    }
  const double variance = squares / count;
  const double correlation = variance > 0 && pairs > 0 ? products / pairs / variance : 0;
  return {mean, std::sqrt(variance), std::clamp(correlation, -kMaxCorrelation, kMaxCorrelation)};
}

Series<Kind> all_plain(const Series<double>& series) {
  Series<Kind> kinds;
  for (const auto& s : series) kinds.emplace_back(s.size(), Kind::kPlain);
  return kinds;
}

/// A double impact cuts one gap into a short one and the rest: the rest is no plain gap either, however long.
std::vector<Kind> kinds_of(const std::vector<double>& gaps, double T) {
  std::vector<Kind> kinds;
  for (const double g : gaps) kinds.push_back(g >= kLongestPlain * T ? Kind::kMissed : Kind::kPlain);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i] > kShortestPlain * T || kinds[i] == Kind::kDoubled) continue;
    kinds[i] = Kind::kDoubled;
    if (i + 1 < gaps.size() && std::fabs(gaps[i] + gaps[i + 1] - T) < kWholeSlack * T)
      kinds[i + 1] = Kind::kDoubled;
  }
  return kinds;
}

/// Periods by which the doubled gaps fall short of one each, over the number of gaps.
double shortfall(const Series<double>& gaps, const Series<Kind>& kinds, double T) {
  double missing = 0, count = 0;
  for (std::size_t s = 0; s < gaps.size(); ++s)
    for (std::size_t i = 0; i < gaps[s].size(); ++i, ++count)
      if (kinds[s][i] == Kind::kDoubled) missing += std::max(0.0, 1 - gaps[s][i] / T);
  return missing / count;
}

Series<double> gaps_of(const Series<int>& onsets) {
  Series<double> gaps;
  for (const auto& P : onsets) {
    gaps.emplace_back();
    for (std::size_t i = 1; i < P.size(); ++i) gaps.back().push_back(P[i] - P[i - 1]);
  }
  return gaps;
}

double median_of(const Series<double>& series) {
  std::vector<double> all;
  for (const auto& s : series) all.insert(all.end(), s.begin(), s.end());
  return median(std::move(all));
}

double share(const Series<Kind>& kinds, Kind wanted) {
  double hits = 0, count = 0;
  for (const auto& s : kinds)
    for (const Kind kind : s) hits += kind == wanted ? 1 : 0, ++count;
  return hits / count;
}

void set_from(const Series<int>& onsets, ClickBank& bank) {
  const Series<double> gaps = gaps_of(onsets);
  const double T = median_of(gaps);
  Series<Kind> kinds;
  for (const auto& g : gaps) kinds.push_back(kinds_of(g, T));
  const SeriesMoments m = moments(gaps, kinds);
  bank.mean_gap_samples = m.mean;
  bank.gap_deviation_samples = m.deviation;
  bank.gap_correlation = m.deviation > kSteadyDeviation * m.mean ? m.correlation : 0;
  // Shares are of the engine's schedule: a double impact makes two gaps of one of its own.
  const double missing = shortfall(gaps, kinds, m.mean), scheduled = 1 - missing;
  bank.miss_share = share(kinds, Kind::kMissed) / scheduled;
  bank.double_share = std::min(missing / scheduled, 1 - bank.miss_share);
}

/// The onsets without second strikes, and how many of these there are for each.
struct Schedule {
  Series<int> first;
  double doubled = 0;
};

Schedule schedule_of(const Series<int>& onsets) {
  Schedule schedule;
  double all = 0, scheduled = 0;
  for (const auto& P : onsets) {
    schedule.first.push_back(first_strikes(P));
    all += static_cast<double>(P.size()), scheduled += static_cast<double>(schedule.first.back().size());
  }
  schedule.doubled = all / scheduled - 1;
  return schedule;
}

}  // namespace

void set_gap_statistics(const Series<int>& onsets, ClickBank& bank) {
  const Schedule schedule = schedule_of(onsets);
  if (!(schedule.doubled >= kMostlyDouble)) return set_from(onsets, bank);
  set_from(schedule.first, bank);
  bank.double_share = std::min(schedule.doubled, 1 - bank.miss_share);
}

void set_plain_gap_statistics(const Series<int>& onsets, ClickBank& bank) {
  const Series<double> gaps = gaps_of(onsets);
  const SeriesMoments m = moments(gaps, all_plain(gaps));
  bank.mean_gap_samples = m.mean;
  bank.gap_deviation_samples = m.deviation;
  bank.gap_correlation = bank.miss_share = bank.double_share = 0;
}

void set_amplitude_statistics(const Series<double>& norms, ClickBank& bank) {
  const SeriesMoments m = moments(norms, all_plain(norms));
  bank.mean_amplitude = m.mean;
  bank.amplitude_deviation = m.deviation;
  bank.amplitude_correlation = m.correlation;
}

}  // namespace rigsound::analysis
