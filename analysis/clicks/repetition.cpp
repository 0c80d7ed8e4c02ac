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
  float best = -1;
  for (long at = later - slack; at <= later + slack; ++at) {
    const auto second = x.segment(at, length).matrix();
    const float power = first.squaredNorm() * second.squaredNorm();
    best = std::max(best, first.dot(second) / std::sqrt(std::max(power, kSilence)));
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
