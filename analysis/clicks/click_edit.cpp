#include "clicks/click_edit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clicks/click_fit.hpp"
#include "clicks/gaps.hpp"
#include "clicks/shift_search.hpp"
#include "kernels/click_kernels.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

// Neighbouring samples of a click are not independent: the modes it excites ring through the whitening. Half
// of the nominal evidence is what the development clips support.
constexpr double kIndependentShare = 0.5;
constexpr double kNegligiblePower = 0.01;
constexpr int kAmplitudeSteps = 5;
constexpr double kNever = 1e8;

struct Requirement {
  double gain;   ///< nats
  double power;  ///< of the median
};
constexpr Requirement kInAGap{5, 0.04}, kAmongOthers{25, 0.15};

/// The evidence without which click i is pruned: close to others as much as an addition needs.
double evidence_to_keep(const ModelClicks& clicks, size_t i, double T_0, double median_power) {
  const size_t last = clicks.onset.size() - 1;
  const double power = clicks.power(static_cast<long>(i));
  const double before = i > 0 ? static_cast<double>(clicks.onset[i] - clicks.onset[i - 1]) : T_0;
  const double after = i < last ? static_cast<double>(clicks.onset[i + 1] - clicks.onset[i]) : T_0;
  if (power < kNegligiblePower * median_power) return kNever;
  if (std::min(before, after) < kShortestGap * T_0) {
    const size_t rival = before < after ? i - 1 : std::min(i + 1, last);
    if (power < clicks.power(static_cast<long>(rival))) return kNever;
  }
  if (std::min(before, after) < kDoubleBelow * T_0)
    return power < kAmongOthers.power * median_power ? kNever : kAmongOthers.gain;
  const bool in_a_gap = before + after > 1.5 * T_0 && clicks.onset[i] >= 0;
  return in_a_gap ? 0.5 : kEvidenceToKeep;
}

Requirement evidence_to_add(const std::vector<long>& onset, long at, double T_0) {
  const auto next = std::lower_bound(onset.begin(), onset.end(), at);
  const bool inside = next != onset.begin() && next != onset.end();
  const double gap = inside ? static_cast<double>(*next - *(next - 1)) / T_0 : 2.0;
  return gap > 1.45 ? kInAGap : kAmongOthers;
}

long distance_to_nearest(const std::vector<long>& onset, long at) {
  long nearest = std::numeric_limits<long>::max();
  for (const long P : onset) nearest = std::min(nearest, std::labs(P - at));
  return nearest;
}

void insert_click(ModelClicks& clicks, const Addition& addition) {
  clicks.onset.push_back(addition.onset);
  clicks.power.conservativeResize(clicks.power.size() + 1);
  clicks.power(clicks.power.size() - 1) = addition.power;
  sort_clicks(clicks);
}

}  // namespace

double removal_cost(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const Eigen::ArrayXd& a2, long onset,
                    double power, int block) {
  const long first = std::max(0L, onset), length = std::min<long>(v.size(), onset + a2.size()) - first;
  if (length <= 0) return 0;
  const auto with = v.segment(first, length), observed = q.segment(first, length);
  const Eigen::ArrayXd without = (with - power * a2.segment(first - onset, length)).max(1e-12);
  return 0.5 * block * kIndependentShare * (divergence(observed, without) - divergence(observed, with));
}

Addition best_addition(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const Eigen::ArrayXd& a2,
                       long block_at, int block) {
  Addition best;
  for (long onset = std::max(0L, block_at - 3); onset <= block_at + 3; ++onset) {
    const long length = std::min<long>(v.size(), onset + a2.size()) - onset;
    if (length < 6) continue;
    const auto shape = a2.head(length);
    const auto now = v.segment(onset, length);
    const Eigen::ArrayXd observed = q.segment(onset, length).min(kOutlierClip * now);
    const Eigen::ArrayXd inverse = now.inverse(), gradient = shape * inverse.square();
    double power = std::max(1e-6, (gradient * (observed - now)).sum() / (shape * gradient).sum());
    Eigen::ArrayXd w;
    for (int step = 0; step < kAmplitudeSteps; ++step) {
      w = now + power * shape;
      const WeighedSums sums = click_kernels().weigh(observed.data(), w.data(), a2.data(),
                                                     std::numeric_limits<double>::max(), length);
      power = std::max(1e-6, power * sums.ax / sums.ay);
    }
    w = now + power * shape;
    const double gain =
        0.5 * block * kIndependentShare * (divergence(observed, now) - divergence(observed, w));
    if (gain > best.gain) best = {onset, power, gain};
  }
  return best;
}

void remove_weak_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, double T_0, int block,
                        ModelClicks& clicks) {
  const Eigen::ArrayXd a2 = sampled_power(shape);
  const double median_power = upper_median(std::vector<double>{clicks.power.begin(), clicks.power.end()});
  while (clicks.onset.size() > kFewestFitted) {
    const Eigen::ArrayXd v = model_variance(shape, clicks, q.size()), clipped = q.min(kOutlierClip * v);
    double worst = 0;
    size_t weakest = clicks.onset.size();
    for (size_t i = 0; i < clicks.onset.size(); ++i) {
      const double evidence =
          removal_cost(clipped, v, a2, clicks.onset[i], clicks.power(static_cast<long>(i)), block);
      const double surplus = evidence - evidence_to_keep(clicks, i, T_0, median_power);
      if (surplus < worst) worst = surplus, weakest = i;
    }
    if (weakest == clicks.onset.size()) return;
    remove_click(clicks, weakest);
    update_powers(q, TrainPower(shape, clicks.onset, q.size()), 2, kOutlierClip, clicks);
  }
}

void add_missed_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, double T_0, int block,
                       const std::vector<long>& candidates, ModelClicks& clicks) {
  const Eigen::ArrayXd a2 = sampled_power(shape);
  const double median_power = upper_median(std::vector<double>{clicks.power.begin(), clicks.power.end()});
  Eigen::ArrayXd v = model_variance(shape, clicks, q.size());
  for (const long at : candidates) {
    if (static_cast<double>(distance_to_nearest(clicks.onset, at)) < 0.30 * T_0) continue;
    const Requirement needed = evidence_to_add(clicks.onset, at, T_0);
    const Addition addition = best_addition(q, v, a2, at, block);
    if (addition.gain <= needed.gain || addition.power <= needed.power * median_power) continue;
    insert_click(clicks, addition);
    v = model_variance(shape, clicks, q.size());
  }
}

}  // namespace rigsound::analysis
