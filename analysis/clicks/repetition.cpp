#include "clicks/repetition.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kShareOfGap = 0.8, kLongestPair_s = 0.03;
constexpr double kSlack_s = 0.001;       // onsets are not known better in noise
constexpr double kPlainGap = 1.5;        // periods: a pause is no pair
constexpr std::size_t kFewestPairs = 3;  // that a median may be taken of
constexpr float kSilence = 1e-20f;

/// The largest within `slack` of `later`.
double best_correlation(const Eigen::Ref<const Eigen::ArrayXf>& x, long earlier, long later, long length,
                        long slack) {
  const auto first = x.segment(earlier, length).matrix();
  const float first_power = first.squaredNorm();
  float second_power = x.segment(later - slack, length).square().sum(), best = -1;
  for (long at = later - slack; at <= later + slack; ++at) {
    const float power = std::max(first_power * second_power, kSilence);
    best = std::max(best, first.dot(x.segment(at, length).matrix()) / std::sqrt(power));
    if (at < later + slack) second_power += x(at + length) * x(at + length) - x(at) * x(at);
  }
  return best;
}

}  // namespace

double repetition(const Eigen::Ref<const Eigen::ArrayXf>& x, const ClickTrain& clicks) {
  const long slack = std::lround(kSlack_s * kAnalysisRate);
  const long length =
      std::lround(std::min(kShareOfGap * clicks.mean_gap_samples, kLongestPair_s * kAnalysisRate));
  std::vector<double> correlation;
  for (std::size_t i = 1; i < clicks.P.size(); ++i) {
    const long earlier = clicks.P[i - 1], later = clicks.P[i];
    const bool whole = earlier >= 0 && later >= slack && later + slack + length <= x.size();
    if (whole && static_cast<double>(later - earlier) < kPlainGap * clicks.mean_gap_samples)
      correlation.push_back(best_correlation(x, earlier, later, length, slack));
  }
  return correlation.size() < kFewestPairs ? 0 : median(std::move(correlation));
}

}  // namespace rigsound::analysis
