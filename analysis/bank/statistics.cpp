#include "bank/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace rigsound::analysis {
namespace {

constexpr double kShortest = 0.6, kLongest = 1.5;  // of the median: what counts as one plain gap
constexpr double kSteady = 0.002;  // sigma_T / T_0 below which only rounding is left to correlate
constexpr double kMaxCorrelation = 0.9;

using Accept = std::function<bool(double)>;

struct Moments {
  double mean = 0, deviation = 0, correlation = 0;  ///< lag-1, between accepted neighbours
};

Moments moments(const Series<double>& series, const Accept& accept) {
  double count = 0, sum = 0, squares = 0, pairs = 0, products = 0;
  for (const auto& s : series)
    for (const double v : s)
      if (accept(v)) sum += v, ++count;
  const double mean = sum / count;
  for (const auto& s : series)
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (!accept(s[i])) continue;
      squares += (s[i] - mean) * (s[i] - mean);
      if (i + 1 < s.size() && accept(s[i + 1])) products += (s[i] - mean) * (s[i + 1] - mean), ++pairs;
    }
  const double variance = squares / count;
  const double correlation = variance > 0 && pairs > 0 ? products / pairs / variance : 0;
  return {mean, std::sqrt(variance), std::clamp(correlation, -kMaxCorrelation, kMaxCorrelation)};
}

Series<double> gaps_of(const Series<int>& onsets) {
  Series<double> gaps;
  for (const auto& P : onsets) {
    gaps.emplace_back();
    for (std::size_t i = 1; i < P.size(); ++i) gaps.back().push_back(P[i] - P[i - 1]);
  }
  return gaps;
}

double median(const Series<double>& series) {
  std::vector<double> all;
  for (const auto& s : series) all.insert(all.end(), s.begin(), s.end());
  std::sort(all.begin(), all.end());
  const std::size_t half = all.size() / 2;
  return all.size() % 2 ? all[half] : 0.5 * (all[half - 1] + all[half]);
}

double share(const Series<double>& series, const Accept& accept) {
  double hits = 0, count = 0;
  for (const auto& s : series)
    for (const double v : s) hits += accept(v) ? 1 : 0, ++count;
  return hits / count;
}

bool any(double) { return true; }

}  // namespace

void set_gap_statistics(const Series<int>& onsets, ClickBank& bank) {
  const Series<double> gaps = gaps_of(onsets);
  const double T = median(gaps);
  const Moments m = moments(gaps, [T](double g) { return g > kShortest * T && g < kLongest * T; });
  bank.T_0 = m.mean;
  bank.sigma_T = m.deviation;
  bank.r_T = m.deviation > kSteady * m.mean ? m.correlation : 0;
  bank.p_miss = share(gaps, [T](double g) { return g >= kLongest * T; });
  bank.p_double = share(gaps, [T](double g) { return g <= kShortest * T; });
}

void set_plain_gap_statistics(const Series<int>& onsets, ClickBank& bank) {
  const Moments m = moments(gaps_of(onsets), any);
  bank.T_0 = m.mean;
  bank.sigma_T = m.deviation;
  bank.r_T = bank.p_miss = bank.p_double = 0;
}

void set_amplitude_statistics(const Series<double>& norms, ClickBank& bank) {
  const Moments m = moments(norms, any);
  bank.B = m.mean;
  bank.sigma_B = m.deviation;
  bank.r_B = m.correlation;
}

}  // namespace rigsound::analysis
