#include "clicks/coherent_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/independent_share.hpp"
#include "clicks/shift_search.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kFarthest_s = 0.008, kFarthest = 0.2;  // the second in periods
constexpr double kWaveform_s = 0.03, kWaveform = 0.8;   // likewise
constexpr double kLead_s = 0.002;                       // of that, before the onset
constexpr std::size_t kFewestAlike = 6;
constexpr double kWideBand = 0.25;  // independent share from which variance alone tells onsets well
constexpr int kAlignments = 6;
// Of 34 drills with fixed modes below 900 Hz in noise as loud the least was 0.43; clicks of noise stay below
// 0.18.
constexpr double kSharesWaveform = 0.4;

long coarse_blocks(double seconds) { return std::lround(seconds * kAnalysisRate / kCoarse); }

/// How far clicks may move and how much of each is compared, blocks of kCoarse samples.
struct Span {
  long reach, length;
  long shifts() const { return 2 * reach + 1; }
};

Span span_of(const ClickTrain& train) {
  const double T_0_s = train.mean_gap_samples / kAnalysisRate;
  return {coarse_blocks(std::min(kFarthest_s, kFarthest * T_0_s)),
          coarse_blocks(std::min(kWaveform_s, kWaveform * T_0_s))};
}

/// Twice the reach and a length of the signal around every click, blocks x clicks; silence beyond its ends.
Eigen::ArrayXXd surroundings(const Eigen::ArrayXd& y, const ClickTrain& train, const Span& span) {
  const Eigen::ArrayXd blocks = block_mean(y, kCoarse);
  Eigen::ArrayXXd around =
      Eigen::ArrayXXd::Zero(span.length + 2 * span.reach, static_cast<long>(train.P.size()));
  for (long i = 0; i < around.cols(); ++i) {
    const long begin = train.P[i] / kCoarse - coarse_blocks(kLead_s) - span.reach;
    const long first = std::max(0L, begin), last = std::min<long>(blocks.size(), begin + around.rows());
    if (first < last)
      around.col(i).segment(first - begin, last - first) = blocks.segment(first, last - first);
  }
  return around;
}

/// What each shift of each click costs by the variance model, nats, shifts x clicks. A narrow band tells
/// less.
Eigen::ArrayXXd variance_costs(const Eigen::ArrayXd& y, double independent, const ClickTrain& train,
                               const Span& span) {
  const Eigen::ArrayXd q = block_power(y, kCoarse);
  ModelClicks clicks;
  clicks.onset = onsets_in_blocks(train.P, kCoarse);
  set_first_powers(q, clicks);
  const EnvelopePower shape = envelope_power(train.envelope, kCoarse);
  update_powers(q, TrainPower(shape, clicks.onset, q.size()), 4, kOutlierClip, clicks);
  const Eigen::ArrayXd a2 = sampled_power(shape), v = model_variance(shape, clicks, q.size());
  const Eigen::ArrayXd clipped = q.min(kOutlierClip * v);
  Eigen::ArrayXXd costs(span.shifts(), static_cast<long>(train.P.size()));
  for (long i = 0; i < costs.cols(); ++i)
    costs.col(i) = shift_costs(clipped, v, shape, a2, clicks.onset[i], clicks.power(i), {span.reach, 1});
  return 0.5 * kCoarse * independent * costs;
}

/// The clicks as they lie now, span.length x clicks.
Eigen::ArrayXXd shifted(const Eigen::ArrayXXd& around, const std::vector<long>& shift, const Span& span) {
  Eigen::ArrayXXd clicks(span.length, around.cols());
  for (long i = 0; i < clicks.cols(); ++i)
    clicks.col(i) = around.col(i).segment(span.reach + shift[i], span.length);
  return clicks;
}

/// Every click to its best shift, given how the others lie. `gain`: nats a product over the noise's power.
void align(const Eigen::ArrayXXd& around, const Eigen::ArrayXXd& costs, double gain, const Span& span,
           std::vector<long>& shift) {
  const Eigen::ArrayXXd clicks = shifted(around, shift, span);
  const Eigen::ArrayXd sum = clicks.rowwise().sum();
  const double noise = (clicks.colwise() - sum / static_cast<double>(clicks.cols())).square().mean();
  Eigen::ArrayXd likelihood(span.shifts());
  for (long i = 0; i < clicks.cols(); ++i) {
    const Eigen::ArrayXd others = (sum - clicks.col(i)) / static_cast<double>(clicks.cols() - 1);
    for (long k = 0; k < likelihood.size(); ++k)
      likelihood(k) = gain / noise * (around.col(i).segment(k, span.length) * others).sum();
    (likelihood - costs.col(i)).maxCoeff(&shift[i]);
  }
  const long common = std::lround(median(std::vector<double>(shift.begin(), shift.end())));
  for (long& s : shift) s = std::clamp(s - common, -span.reach, span.reach);
}

/// Mean product of two clicks over mean power of one: 1 for one waveform, about 0 for independent noise.
double coherence(const Eigen::ArrayXXd& clicks) {
  const double own = clicks.square().sum(), all = clicks.rowwise().sum().square().sum();
  return own > 0 ? (all - own) / (own * static_cast<double>(clicks.cols() - 1)) : 0;
}

double mean_move(const std::vector<long>& shift) {
  const auto add = [](long sum, long s) { return sum + std::abs(s); };
  return static_cast<double>(std::accumulate(shift.begin(), shift.end(), 0L, add)) /
         static_cast<double>(shift.size());
}

}  // namespace

ClickTrain aligned_to_waveform(const Eigen::ArrayXd& y, ClickTrain train) {
  if (train.P.size() < kFewestAlike) return train;
  const double independent = independent_share(y);
  if (independent > kWideBand) return train;
  const Span span = span_of(train);
  const Eigen::ArrayXXd around = surroundings(y, train, span);
  const Eigen::ArrayXXd costs = variance_costs(y, independent, train, span);
  std::vector<long> shift(train.P.size());
  for (int i = 0; i < kAlignments; ++i)
    align(around, costs, std::min(1.0, independent * kCoarse), span, shift);
  if (mean_move(shift) < 1 || coherence(shifted(around, shift, span)) < kSharesWaveform) return train;
  const int last = static_cast<int>(y.size()) - 1;
  for (std::size_t i = 0; i < shift.size(); ++i)
    train.P[i] = std::clamp(train.P[i] + static_cast<int>(shift[i]) * kCoarse, 0, last);
  std::sort(train.P.begin(), train.P.end());
  return refitted(y, train);
}

}  // namespace rigsound::analysis
