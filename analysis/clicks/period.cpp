#include "clicks/period.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "clicks/candidates.hpp"
#include "kernels/click_kernels.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSpread = 0.06;  ///< of the lag
constexpr int kPeaks = 4;

/// Unbiased autocorrelation over r(0), lags 0 … last.
Eigen::ArrayXd autocorrelation(const Eigen::ArrayXd& x, long last) {
  const long n = x.size();
  Eigen::ArrayXd centred = Eigen::ArrayXd::Zero(n + 1), r(last + 2);  // a zero behind: lags go by twos
  centred.head(n) = x - x.mean();
  for (long lag = 0; lag <= last; lag += 2) {
    const double* from = centred.data() + lag;
    const PairOfSums sums = click_kernels().products(centred.data(), from, from + 1, n - lag);
    r(lag) = sums.first / static_cast<double>(n - lag);
    r(lag + 1) = sums.second / static_cast<double>(n - lag - 1);
  }
  return r.head(last + 1) / std::max(r(0), 1e-30);
}

Eigen::ArrayXd averaged_over_spread(const Eigen::ArrayXd& r, long first, long last) {
  Eigen::ArrayXd mean(last - first);
  for (long lag = first; lag < last; ++lag) {
    const long a = static_cast<long>(static_cast<double>(lag) * (1 - kSpread));
    const long b = static_cast<long>(static_cast<double>(lag) * (1 + kSpread)) + 1;
    mean(lag - first) = r.segment(a, b - a).mean();
  }
  return mean;
}

}  // namespace

std::vector<int> period_hypotheses(const Eigen::ArrayXd& activity, double block_rate,
                                   const RateRange& range) {
  const long first = static_cast<long>(block_rate / range.fastest_hz);
  const long last = std::min(static_cast<long>(block_rate / range.slowest_hz), activity.size() / 3);
  if (last < first + 3) return {};
  const long furthest = static_cast<long>(static_cast<double>(last) * (1 + kSpread)) + 1;
  const Eigen::ArrayXd mean = averaged_over_spread(autocorrelation(activity, furthest), first, last);
  std::vector<int> lags = peaks(mean, -1, 1);
  if (lags.empty()) {
    long highest = 0;
    mean.maxCoeff(&highest);
    lags.push_back(static_cast<int>(highest));
  }
  std::stable_sort(lags.begin(), lags.end(), [&](int a, int b) { return mean(a) > mean(b); });
  if (lags.size() > kPeaks) lags.resize(kPeaks);
  std::set<int> periods;
  for (const int lag : lags)
    for (const double octave : {0.5, 1.0, 2.0}) {
      const double period = octave * static_cast<double>(lag + first);
      if (block_rate / period >= range.slowest_hz && block_rate / period <= range.fastest_hz)
        periods.insert(static_cast<int>(std::lround(period)));
    }
  return {periods.begin(), periods.end()};
}

}  // namespace rigsound::analysis
