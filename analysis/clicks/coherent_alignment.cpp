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
#include "kernels/click_kernels.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kFineBlock = 2;  // samples: waveforms up to 12 kHz are told apart; those of kCoarse up to 3 kHz
constexpr double kFarthest_s = 0.008, kFarthest = 0.2;  // the second in periods
constexpr double kWaveform_s = 0.03, kWaveform = 0.8;   // likewise
constexpr double kLead_s = 0.002;                       // of that, before the onset
constexpr std::size_t kFewestAlike = 6;
constexpr double kWideBand = 0.4;  // independent share from which variance alone tells onsets well
// Beliefs in shifts begin wide and sharpen: what all clicks have in common appears from its lowest
// frequencies up, and none is set on the wrong period of its loudest mode before the others are known.
constexpr int kCoarseRounds = 16, kFineRounds = 4;
constexpr float kFirstTemperature = 4, kCooledAfter = 13;  // the second in rounds
constexpr float kLeastNoise = 0.01f;                       // of the clicks' power
// Of 75 drills found at -6 dB those of modes had 0.19 and more, those of noise 0.15 and less.
constexpr double kSharesWaveform = 0.17;

/// How far clicks may move and how much of each is compared, in blocks of so many samples.
struct Span {
  int block;
  long reach, length;
  long shifts() const { return 2 * reach + 1; }
};

/// Of kCoarse blocks, whole ones.
Span span_of(const ClickTrain& train) {
  const double T_0_s = train.mean_gap_samples / kAnalysisRate;
  const auto blocks = [](double seconds) { return std::lround(seconds * kAnalysisRate / kCoarse); };
  return {kCoarse, blocks(std::min(kFarthest_s, kFarthest * T_0_s)),
          blocks(std::min(kWaveform_s, kWaveform * T_0_s))};
}

Span in_finer_blocks(const Span& span, int block) {
  const int ratio = span.block / block;
  return {block, span.reach * ratio, span.length * ratio};
}

/// Twice the reach and a length of the signal around every click, blocks x clicks; silence beyond its ends.
Eigen::ArrayXXf surroundings(const Eigen::ArrayXd& y, const ClickTrain& train, const Span& span) {
  const long lead = std::lround(kLead_s * kAnalysisRate / kCoarse) * kCoarse;
  Eigen::ArrayXXf around(span.length + 2 * span.reach, static_cast<long>(train.P.size()));
  for (long i = 0; i < around.cols(); ++i) {
    Eigen::ArrayXd samples = Eigen::ArrayXd::Zero(around.rows() * span.block);
    const long begin = train.P[i] - lead - span.reach * span.block;
    const long first = std::max(0L, begin), last = std::min(y.size(), begin + samples.size());
    if (first < last) samples.segment(first - begin, last - first) = y.segment(first, last - first);
    around.col(i) = block_mean(samples, span.block).cast<float>();
  }
  return around;
}

/// What each shift of each click costs by the variance model, nats over the least, shifts x clicks. A narrow
/// band tells less. `span`: of kCoarse blocks.
Eigen::ArrayXXf variance_costs(const Eigen::ArrayXd& y, double independent, const ClickTrain& train,
                               const Span& span) {
  const Eigen::ArrayXd q = block_power(y, kCoarse);
  ModelClicks clicks;
  clicks.onset = onsets_in_blocks(train.P, kCoarse);
  set_first_powers(q, clicks);
  const EnvelopePower shape = envelope_power(train.envelope, kCoarse);
  update_powers(q, TrainPower(shape, clicks.onset, q.size()), 4, kOutlierClip, clicks);
  const Eigen::ArrayXd a2 = sampled_power(shape), v = model_variance(shape, clicks, q.size());
  const Eigen::ArrayXd clipped = q.min(kOutlierClip * v);
  Eigen::ArrayXXf costs(span.shifts(), static_cast<long>(train.P.size()));
  for (long i = 0; i < costs.cols(); ++i) {
    const Eigen::ArrayXd divergences =
        shift_costs(clipped, v, shape, a2, clicks.onset[i], clicks.power(i), {span.reach, 1});
    costs.col(i) = (0.5 * kCoarse * independent * (divergences - divergences.minCoeff())).cast<float>();
  }
  return costs;
}

/// Figures of shifts by blocks, at the shifts by blocks of a `ratio`-th: linear between.
Eigen::ArrayXXf finer(const Eigen::ArrayXXf& by_shift, int ratio) {
  Eigen::ArrayXXf fine(ratio * (by_shift.rows() - 1) + 1, by_shift.cols());
  for (long k = 0; k < fine.rows(); ++k) {
    const long left = k / ratio, right = std::min(left + 1, by_shift.rows() - 1);
    const float along = static_cast<float>(k % ratio) / static_cast<float>(ratio);
    fine.row(k) = (1 - along) * by_shift.row(left) + along * by_shift.row(right);
  }
  return fine;
}

/// sum over m of h(m) x(k + m), at every k where x holds all of h.
Eigen::ArrayXf correlation(const Eigen::Ref<const Eigen::ArrayXf>& x,
                           const Eigen::Ref<const Eigen::ArrayXf>& h) {
  const Eigen::ArrayXf taps = h.reverse();
  Eigen::ArrayXf r(x.size() - h.size() + 1);
  click_kernels().filter(x.data() + h.size() - 1, r.size(), taps.data(), static_cast<int>(taps.size()),
                         r.data());
  return r;
}

/// Of each shift of each click, shifts x clicks. A temperature of 1 believes what the likelihoods say.
Eigen::ArrayXXf beliefs(const Eigen::ArrayXXf& likelihoods, float temperature) {
  Eigen::ArrayXXf belief = ((likelihoods.rowwise() - likelihoods.colwise().maxCoeff()) / temperature).exp();
  belief.rowwise() /= belief.colwise().sum().eval();
  return belief;
}

/// Each click in the mean over where it may lie, span.length x clicks.
Eigen::ArrayXXf expected(const Eigen::ArrayXXf& around, const Eigen::ArrayXXf& belief, const Span& span) {
  Eigen::ArrayXXf clicks(span.length, around.cols());
  for (long i = 0; i < clicks.cols(); ++i) clicks.col(i) = correlation(around.col(i), belief.col(i));
  return clicks;
}

/// Of what is not the mean waveform. `power`: of all.
float noise_beside(const Eigen::ArrayXXf& clicks, const Eigen::ArrayXf& sum, float power) {
  const float n = static_cast<float>(clicks.cols()), of_mean = sum.square().mean() / (n * n),
              own = clicks.square().mean() / n;
  return std::max(power - std::max(0.0f, of_mean - own), kLeastNoise * power);
}

/// The clicks by blocks of one length, and what is known of their shifts without comparing them.
struct ClicksInBlocks {
  Span span;
  Eigen::ArrayXXf around;  ///< see surroundings()
  Eigen::ArrayXXf costs;   ///< see variance_costs()
  float independent;       ///< share of the blocks
};

ClicksInBlocks clicks_in_blocks(const Eigen::ArrayXd& y, double independent, const ClickTrain& train,
                                const Span& span, Eigen::ArrayXXf costs) {
  return {span, surroundings(y, train, span), std::move(costs),
          static_cast<float>(std::min(1.0, independent * span.block))};
}

/// Log likelihoods, nats, shifts x clicks: each click by the mean of the others, and by its variance.
Eigen::ArrayXXf likelihoods_given(const Eigen::ArrayXXf& expected, const ClicksInBlocks& clicks) {
  const Eigen::ArrayXf sum = expected.rowwise().sum();
  const float noise = noise_beside(
      expected, sum, clicks.around.middleRows(clicks.span.reach, clicks.span.length).square().mean());
  Eigen::ArrayXXf likelihoods = -clicks.costs;
  for (long i = 0; i < expected.cols(); ++i) {
    const Eigen::ArrayXf others = (sum - expected.col(i)) / static_cast<float>(expected.cols() - 1);
    likelihoods.col(i) += clicks.independent / noise * correlation(clicks.around.col(i), others);
  }
  return likelihoods;
}

float temperature_in(int round) {
  return std::max(1.0f,
                  kFirstTemperature - (kFirstTemperature - 1) * static_cast<float>(round) / kCooledAfter);
}

/// Rounds of expectation and maximisation, of whose likelihoods the last are returned.
Eigen::ArrayXXf learned(const ClicksInBlocks& clicks, int first_round, int rounds,
                        Eigen::ArrayXXf likelihoods) {
  for (int round = first_round; round < first_round + rounds; ++round)
    likelihoods = likelihoods_given(
        expected(clicks.around, beliefs(likelihoods, temperature_in(round)), clicks.span), clicks);
  return likelihoods;
}

/// Blocks, without the median move.
std::vector<long> most_likely_shifts(const Eigen::ArrayXXf& likelihoods, const Span& span) {
  std::vector<long> shift(static_cast<std::size_t>(likelihoods.cols()));
  for (long i = 0; i < likelihoods.cols(); ++i) likelihoods.col(i).maxCoeff(&shift[i]);
  const long common = std::lround(median(std::vector<double>(shift.begin(), shift.end())));
  for (long& s : shift) s = std::clamp(s - common, -span.reach, span.reach);
  return shift;
}

/// The clicks as they lie then, span.length x clicks.
Eigen::ArrayXXf shifted(const Eigen::ArrayXXf& around, const std::vector<long>& shift, const Span& span) {
  Eigen::ArrayXXf clicks(span.length, around.cols());
  for (long i = 0; i < clicks.cols(); ++i)
    clicks.col(i) = around.col(i).segment(span.reach + shift[i], span.length);
  return clicks;
}

/// Mean product of two clicks over mean power of one: 1 for one waveform, about 0 for independent noise.
double coherence(const Eigen::ArrayXXf& clicks) {
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
  constexpr int kRatio = kCoarse / kFineBlock;
  const Span span = span_of(train);
  const ClicksInBlocks coarse =
      clicks_in_blocks(y, independent, train, span, variance_costs(y, independent, train, span));
  const ClicksInBlocks fine =
      clicks_in_blocks(y, independent, train, in_finer_blocks(span, kFineBlock), finer(coarse.costs, kRatio));
  const Eigen::ArrayXXf rough = learned(coarse, 0, kCoarseRounds, -coarse.costs);
  const Eigen::ArrayXXf likelihoods = learned(fine, kCoarseRounds, kFineRounds, finer(rough, kRatio));
  const std::vector<long> shift = most_likely_shifts(likelihoods, fine.span);
  if (mean_move(shift) < kRatio || coherence(shifted(fine.around, shift, fine.span)) < kSharesWaveform)
    return train;
  const int last = static_cast<int>(y.size()) - 1;
  for (std::size_t i = 0; i < shift.size(); ++i)
    train.P[i] = std::clamp(train.P[i] + static_cast<int>(shift[i]) * kFineBlock, 0, last);
  std::sort(train.P.begin(), train.P.end());
  return refitted(y, train);
}

}  // namespace rigsound::analysis
