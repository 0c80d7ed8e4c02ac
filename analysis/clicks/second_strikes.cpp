#include "clicks/second_strikes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "clicks/click_edit.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/envelope_fit.hpp"
#include "clicks/shift_search.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kEarliest_ms = 8;                                     // two windows of the statistic
constexpr double kEarliest = 0.1, kLatest = 0.45, kRoomBehind = 0.28;  // periods
constexpr double kClearAsClicks = 0.5;                                 // of their median statistic
constexpr double kSameTime = 0.08;                                     // of the time between two strikes
constexpr double kConstant = 0.6;                                      // of the clear ones at that time
constexpr double kShareStruckTwice = 0.2;
constexpr std::size_t kFewestTwice = 6;
constexpr double kStrong = 0.25;  // of the power of the clicks they follow
constexpr long kReach = 12;       // blocks of kCoarse samples: the statistic tells the time to 2 ms

/// A candidate some time after the last click before it.
struct Follower {
  long after;   ///< index of that click
  double time;  ///< samples
  double z;     ///< its statistic
  long block;   ///< of the candidates
};

std::vector<Follower> followers(const Candidates& candidates, const ClickTrain& train) {
  const double T_0 = train.mean_gap_samples,
               earliest = std::max(kEarliest * T_0, kEarliest_ms * kAnalysisRate / 1000);
  std::vector<Follower> found;
  for (const int block : candidates.block) {
    const int at = block * kCandidateBlock;
    const auto next = std::upper_bound(train.P.begin(), train.P.end(), at);
    if (next == train.P.begin()) continue;
    const double time = at - *(next - 1);
    if (time < earliest || time > kLatest * T_0) continue;
    if (next != train.P.end() && *next - at < kRoomBehind * T_0) continue;
    found.push_back({next - train.P.begin() - 1, time, candidates.z(block), block});
  }
  return found;
}

double usual_statistic(const Candidates& candidates, const ClickTrain& train) {
  std::vector<double> z;
  for (const int P : train.P) {
    const long block = P / kCandidateBlock, first = std::max(0L, block - 6),
               last = std::min(candidates.z.size(), block + 7);
    z.push_back(candidates.z.segment(first, last - first).maxCoeff());
  }
  return upper_median(std::move(z));
}

/// The time after which second strikes come, samples; 0 where there are none.
double usual_time(const std::vector<Follower>& all, double clear, std::size_t clicks) {
  std::vector<double> times;
  for (const Follower& f : all)
    if (f.z >= clear) times.push_back(f.time);
  std::sort(times.begin(), times.end());
  double best = 0;
  std::size_t most = 0;
  for (const double time : times) {
    const auto first = std::lower_bound(times.begin(), times.end(), time * (1 - kSameTime)),
               last = std::upper_bound(times.begin(), times.end(), time * (1 + kSameTime));
    const auto near = static_cast<std::size_t>(last - first);
    if (near > most) most = near, best = *(first + (last - first) / 2);
  }
  const bool enough = most >= kFewestTwice &&
                      static_cast<double>(most) >= kShareStruckTwice * static_cast<double>(clicks) &&
                      static_cast<double>(most) >= kConstant * static_cast<double>(times.size());
  return enough ? best : 0;
}

/// The clearest follower of every click that comes about `time` after it, blocks of kCoarse samples.
std::vector<long> second_onsets(const std::vector<Follower>& all, double time, std::size_t clicks) {
  std::vector<const Follower*> of_click(clicks);
  for (const Follower& f : all) {
    const Follower*& best = of_click[f.after];
    if (std::fabs(f.time - time) <= kSameTime * time && (best == nullptr || f.z > best->z)) best = &f;
  }
  std::vector<long> onsets;
  for (const Follower* f : of_click)
    if (f != nullptr) onsets.push_back(f->block * kCandidateBlock / kCoarse);
  return onsets;
}

/// Clicks and second strikes with the envelope that both have, on blocks of kCoarse samples.
ModelClicks fitted_with(const std::vector<long>& second, const Eigen::ArrayXd& q, const ClickTrain& train,
                        ClickEnvelope& envelope) {
  ModelClicks clicks;
  clicks.onset = onsets_in_blocks(train.P, kCoarse);
  clicks.onset.insert(clicks.onset.end(), second.begin(), second.end());
  std::sort(clicks.onset.begin(), clicks.onset.end());
  set_first_powers(q, clicks);
  fit_coarsely(q, train.mean_gap_samples, 60, kReach, envelope, clicks);
  return clicks;
}

/// Which of the clicks follow the one before them within `latest` blocks.
std::vector<bool> second_ones(const std::vector<long>& onset, double latest) {
  std::vector<bool> second(onset.size());
  for (std::size_t i = 1; i < onset.size(); ++i)
    second[i] = !second[i - 1] && static_cast<double>(onset[i] - onset[i - 1]) <= latest;
  return second;
}

/// Power of the second strikes over that of the clicks they follow, median.
double strength(const ModelClicks& clicks, const std::vector<bool>& second) {
  std::vector<double> ratio;
  for (std::size_t i = 1; i < second.size(); ++i) {
    const long at = static_cast<long>(i);
    if (second[i]) ratio.push_back(clicks.power(at) / std::max(clicks.power(at - 1), 1e-12));
  }
  return ratio.empty() ? 0 : upper_median(std::move(ratio));
}

void remove_doubtful(const Eigen::ArrayXd& q, const EnvelopePower& shape, const std::vector<bool>& second,
                     ModelClicks& clicks) {
  const Eigen::ArrayXd a2 = sampled_power(shape);
  const Eigen::ArrayXd v = model_variance(shape, clicks, q.size());
  const Eigen::ArrayXd clipped = q.min(kOutlierClip * v);
  for (std::size_t i = second.size(); i-- > 0;)
    if (second[i] && removal_cost(clipped, v, a2, clicks.onset[i], clicks.power(static_cast<long>(i)),
                                  kCoarse) < kEvidenceToKeep)
      remove_click(clicks, i);
}

}  // namespace

ClickTrain with_second_strikes(const Eigen::ArrayXd& y, const Candidates& candidates, ClickTrain train) {
  // The beats of modes within a narrow band come a constant time after the clicks too.
  if (train.P.size() < kFewestTwice || candidates.narrow) return train;
  const std::vector<Follower> all = followers(candidates, train);
  const double time = usual_time(all, kClearAsClicks * usual_statistic(candidates, train), train.P.size());
  if (time == 0) return train;
  const Eigen::ArrayXd q = block_power(y, kCoarse);
  const std::vector<long> first = onsets_in_blocks(train.P, kCoarse);
  // Of the clicks until their second strikes.
  ClickEnvelope envelope = first_envelope(q, first, time, kCoarse);
  ModelClicks clicks = fitted_with(second_onsets(all, time, first.size()), q, train, envelope);
  const std::vector<bool> second = second_ones(clicks.onset, (1 + 2 * kSameTime) * time / kCoarse);
  if (strength(clicks, second) < kStrong) return train;
  remove_doubtful(q, envelope_power(envelope, kCoarse), second, clicks);
  ClickTrain twice = fit_finely(y, train.mean_gap_samples, envelope, std::move(clicks), {});
  return twice.P.size() > train.P.size() ? twice : train;
}

}  // namespace rigsound::analysis
