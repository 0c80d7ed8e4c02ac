#include "clicks/shift_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace rigsound::analysis {
namespace {

constexpr double kTruncation = 1e-5;  ///< of a^2: -50 dB
constexpr double kSmallestVariance = 1e-12;
constexpr int kNodes = 5;

/// Lagrange's polynomial through (node, value) at x.
double interpolate(const std::array<double, kNodes>& node, const std::array<double, kNodes>& value,
                   double x) {
  double sum = 0;
  for (int j = 0; j < kNodes; ++j) {
    double weight = 1;
    for (int k = 0; k < kNodes; ++k)
      if (k != j) weight *= (x - node[k]) / (node[j] - node[k]);
    sum += weight * value[j];
  }
  return sum;
}

/// The part of the divergence beyond the reach of any attack, as a function of the shift.
class TailCost {
 public:
  TailCost(const Eigen::Ref<const Eigen::ArrayXd>& q, const Eigen::Ref<const Eigen::ArrayXd>& others,
           const Eigen::Ref<const Eigen::ArrayXd>& tail, double decay, long reach) {
    constexpr int kMiddle = kNodes / 2;
    for (int j = 0; j < kNodes; ++j) {
      node_[j] = static_cast<double>(reach) * (j - kMiddle) / kMiddle;
      value_[j] = q.size() > 0 ? divergence(q, others + tail * std::pow(decay, -node_[j])) : 0;
    }
  }
  double operator()(double shift) const { return interpolate(node_, value_, shift); }

 private:
  std::array<double, kNodes> node_{}, value_{};
};

void add_click(const Eigen::ArrayXd& a2, long onset, double power, Eigen::ArrayXd& v) {
  const long first = std::max(0L, onset), last = std::min<long>(v.size(), onset + a2.size());
  if (first < last) v.segment(first, last - first) += power * a2.segment(first - onset, last - first);
}

}  // namespace

Eigen::ArrayXd sampled_power(const EnvelopePower& shape) {
  const long attack = shape.attack.size();
  const long tail = std::max(1L, static_cast<long>(std::ceil(std::log(kTruncation) / std::log(shape.decay))));
  Eigen::ArrayXd a2(attack + tail);
  a2.head(attack) = shape.attack;
  double power = shape.tail;
  for (long k = attack; k < a2.size(); ++k, power *= shape.decay) a2(k) = power;
  return a2;
}

Eigen::ArrayXd shift_costs(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const EnvelopePower& shape,
                           const Eigen::ArrayXd& a2, long onset, double power, const ShiftRange& range) {
  const long first = std::max(0L, onset - range.reach), last = std::min<long>(v.size(), onset + a2.size());
  const long shifts = 2 * range.reach / range.step + 1;
  if (first >= last) return Eigen::ArrayXd::Zero(shifts);
  Eigen::ArrayXd others = v.segment(first, last - first);
  const long begin = std::max(0L, onset);
  others.tail(last - begin) -= power * a2.segment(begin - onset, last - begin);
  others = others.max(kSmallestVariance);

  const long split = std::clamp(onset + range.reach + shape.attack.size(), first, last), near = split - first;
  const TailCost tail(q.segment(split, last - split), others.tail(last - split),
                      power * a2.segment(split - onset, last - split), shape.decay, range.reach);
  Eigen::ArrayXd costs(shifts), w(near);
  for (long k = 0; k < shifts; ++k) {
    const long shift = k * range.step - range.reach, start = std::max(first, onset + shift);
    w = others.head(near);
    const long length = std::min<long>(split - start, a2.size() - (start - onset - shift));
    if (length > 0) w.segment(start - first, length) += power * a2.segment(start - onset - shift, length);
    costs(k) = divergence(q.segment(first, near), w) + tail(static_cast<double>(shift));
  }
  return costs;
}

void shift_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, const ShiftRange& range,
                  ModelClicks& clicks) {
  const Eigen::ArrayXd a2 = sampled_power(shape);
  Eigen::ArrayXd v = model_variance(shape, clicks, q.size());
  const Eigen::ArrayXd clipped = q.min(kOutlierClip * v);
  std::vector<long> order(clicks.onset.size());
  std::iota(order.begin(), order.end(), 0L);
  std::stable_sort(order.begin(), order.end(),
                   [&](long a, long b) { return clicks.power(a) > clicks.power(b); });
  for (const long i : order) {
    long best = 0;
    shift_costs(clipped, v, shape, a2, clicks.onset[i], clicks.power(i), range).minCoeff(&best);
    const long shift = best * range.step - range.reach;
    if (shift == 0) continue;
    add_click(a2, clicks.onset[i], -clicks.power(i), v);
    add_click(a2, clicks.onset[i] += shift, clicks.power(i), v);
    v = v.max(clicks.floor);
  }
  sort_clicks(clicks);
}

}  // namespace rigsound::analysis
