#include "clicks/click_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clicks/click_edit.hpp"
#include "clicks/envelope_fit.hpp"
#include "clicks/gaps.hpp"
#include "clicks/shift_search.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kFine = 2;  // samples a block
constexpr int kRounds = 3, kRoughRounds = 2;
constexpr long kFullRateReach = 16;

void rescale(ModelClicks& clicks, int from, int to) {
  for (long& P : clicks.onset) P = std::lround(static_cast<double>(P) * from / to);
}

/// The selected clicks, and one a period before the first sample: a segment cut out of drilling begins with
/// the tails of what came before, which together are one exponential. Without it the floor takes them, and
/// part of every other tail with them. In silence it gets no power and is pruned; it never counts as found.
ModelClicks start(const Eigen::ArrayXd& q, const Selection& selection, double T_0, Eigen::ArrayXd others) {
  ModelClicks clicks;
  clicks.others = std::move(others);
  clicks.onset.assign(selection.block.begin(), selection.block.end());
  rescale(clicks, kCandidateBlock, kCoarse);
  clicks.onset.insert(clicks.onset.begin(), -std::lround(T_0 / kCoarse));
  set_first_powers(q, clicks);
  return clicks;
}

void coarse_rounds(const Eigen::ArrayXd& q, const std::vector<long>& candidates, int rounds, double& T_0,
                   ClickEnvelope& envelope, ModelClicks& clicks) {
  for (int round = 0; round < rounds; ++round) {
    const long reach = static_cast<long>((round == 0 ? 0.10 : 0.05) * T_0 / kCoarse) + 1;
    const EnvelopePower shape = fit_coarsely(q, T_0, round == 0 ? 60 : 40, reach, envelope, clicks);
    remove_weak_clicks(q, shape, T_0 / kCoarse, kCoarse, clicks);
    if (round + 1 < rounds) add_missed_clicks(q, shape, T_0 / kCoarse, kCoarse, candidates, clicks);
    if (clicks.onset.size() > 3) T_0 = median_gap(clicks.onset) * kCoarse;
  }
}

ClickTrain train_of(const ModelClicks& clicks, const ClickEnvelope& envelope, double T_0, long length) {
  ClickTrain train;
  train.envelope = envelope;
  train.mean_gap_samples = T_0;
  for (size_t i = 0; i < clicks.onset.size(); ++i) {
    // A click that began before the first sample shows only its tail: it counts from the first sample.
    if (clicks.onset[i] < -static_cast<long>(envelope.attack_samples) || clicks.onset[i] >= length) continue;
    train.P.push_back(static_cast<int>(std::max(0L, clicks.onset[i])));
    train.beta.push_back(std::sqrt(clicks.power(static_cast<long>(i))));
  }
  return train;
}

/// The last of all fits: powers at full rate.
ClickTrain finished(const Eigen::ArrayXd& power, double T_0, const ClickEnvelope& envelope,
                    ModelClicks& clicks) {
  update_powers(power, TrainPower(envelope_power(envelope, 1), clicks.onset, power.size()), 6, 1e9, clicks);
  return train_of(clicks, envelope, T_0, power.size());
}

Eigen::ArrayXd in_blocks(const Eigen::ArrayXd& others, int block) {
  return others.size() > 0 ? block_mean(others, block) : others;
}

}  // namespace

EnvelopePower fit_coarsely(const Eigen::ArrayXd& q, double T_0, int iterations, long reach,
                           ClickEnvelope& envelope, ModelClicks& clicks) {
  fit_envelope(q, T_0, {kCoarse, iterations, 3}, envelope, clicks);
  EnvelopePower shape = envelope_power(envelope, kCoarse);
  shift_clicks(q, shape, {reach, 1}, clicks);
  update_powers(q, TrainPower(shape, clicks.onset, q.size()), 4, kOutlierClip, clicks);
  return shape;
}

ClickTrain fit_finely(const Eigen::ArrayXd& y, double T_0, ClickEnvelope envelope, ModelClicks clicks,
                      const Eigen::ArrayXd& others) {
  rescale(clicks, kCoarse, kFine);
  clicks.others = in_blocks(others, kFine);
  fit_envelope(block_power(y, kFine), T_0, {kFine, 40, 2}, envelope, clicks);
  rescale(clicks, kFine, 1);
  clicks.others = others;
  const Eigen::ArrayXd power = y.square();
  const EnvelopePower shape = envelope_power(envelope, 1);
  for (const long step : {2L, 1L}) shift_clicks(power, shape, {kFullRateReach, step}, clicks);
  return finished(power, T_0, envelope, clicks);
}

ClickTrain refitted(const Eigen::ArrayXd& y, const ClickTrain& train, const Eigen::ArrayXd& others) {
  const Eigen::ArrayXd q = block_power(y, kFine);
  ModelClicks clicks;
  clicks.onset.assign(train.P.begin(), train.P.end());
  rescale(clicks, 1, kFine);
  clicks.others = in_blocks(others, kFine);
  set_first_powers(q, clicks);
  ClickEnvelope envelope = train.envelope;
  fit_envelope(q, train.mean_gap_samples, {kFine, 40, 2}, envelope, clicks);
  rescale(clicks, kFine, 1);
  clicks.others = others;
  return finished(y.square(), train.mean_gap_samples, envelope, clicks);
}

ClickTrain fit_clicks(const Eigen::ArrayXd& y, const Candidates& candidates, const Selection& selection,
                      FitEffort effort, const Eigen::ArrayXd& others) {
  const Eigen::ArrayXd q = block_power(y, kCoarse);
  std::vector<long> candidate_blocks;
  for (const int block : candidates.block) candidate_blocks.push_back(block * (kCandidateBlock / kCoarse));
  double T_0 = selection.mean_gap_blocks * kCandidateBlock;
  ModelClicks clicks = start(q, selection, T_0, in_blocks(others, kCoarse));
  const Eigen::ArrayXd own = others.size() > 0 ? (q - clicks.others).max(0).eval() : q;
  ClickEnvelope envelope = first_envelope(own, {clicks.onset.begin() + 1, clicks.onset.end()}, T_0, kCoarse);
  const bool rough = effort == FitEffort::kRough;
  coarse_rounds(q, candidate_blocks, rough ? kRoughRounds : kRounds, T_0, envelope, clicks);
  if (rough) {
    rescale(clicks, kCoarse, 1);
    return train_of(clicks, envelope, T_0, y.size());
  }

  return fit_finely(y, T_0, envelope, std::move(clicks), others);
}

}  // namespace rigsound::analysis
