#include "clicks/variance_model.hpp"

#include <algorithm>
#include <numeric>

namespace rigsound::analysis {

double log_sum(const Eigen::Ref<const Eigen::ArrayXd>& w) {
  // One logarithm for eight factors; their product stays within the range of a double.
  const long m = w.size() / 8;
  const auto part = [&](long k) { return w.segment(k * m, m); };
  const double products =
      (part(0) * part(1) * part(2) * part(3) * part(4) * part(5) * part(6) * part(7)).log().sum();
  return products + w.tail(w.size() - 8 * m).log().sum();
}

double divergence(const Eigen::Ref<const Eigen::ArrayXd>& q, const Eigen::Ref<const Eigen::ArrayXd>& w) {
  return log_sum(w) + (q / w).sum();
}

double model_cost(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, int block) {
  return 0.5 * block * (log_sum(v) + (q / v).min(kOutlierClip).sum());
}

void model_variance(const TrainPower& train, const ModelClicks& clicks, Eigen::ArrayXd& v) {
  train.spread(clicks.power, clicks.floor, v);
  if (clicks.others.size() > 0) v += clicks.others;
}

void update_powers(const Eigen::ArrayXd& q, const TrainPower& train, int sweeps, double clip,
                   ModelClicks& clicks) {
  Eigen::ArrayXd v, inverse, slope;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    model_variance(train, clicks, v);
    inverse = v.inverse();
    slope = (q * inverse).min(clip) * inverse;
    const Eigen::ArrayXd ratio = (train.gather(slope) + 1e-30) / (train.gather(inverse) + 1e-30);
    if (sweep == 0)
      clicks.power *= ratio;
    else
      clicks.power *= ratio.sqrt();
    clicks.floor *= std::sqrt(slope.sum() / inverse.sum());
  }
}

void sort_clicks(ModelClicks& clicks) {
  std::vector<long> order(clicks.onset.size());
  std::iota(order.begin(), order.end(), 0L);
  std::stable_sort(order.begin(), order.end(),
                   [&](long a, long b) { return clicks.onset[a] < clicks.onset[b]; });
  const ModelClicks old = clicks;
  for (size_t i = 0; i < order.size(); ++i) {
    clicks.onset[i] = old.onset[order[i]];
    clicks.power(static_cast<long>(i)) = old.power(order[i]);
  }
}

void remove_click(ModelClicks& clicks, size_t i) {
  const long at = static_cast<long>(i), after = clicks.power.size() - at - 1;
  clicks.onset.erase(clicks.onset.begin() + at);
  clicks.power.segment(at, after) = clicks.power.tail(after).eval();
  clicks.power.conservativeResize(clicks.power.size() - 1);
}

}  // namespace rigsound::analysis
