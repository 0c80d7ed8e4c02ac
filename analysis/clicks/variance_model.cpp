#include "clicks/variance_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernels/click_kernels.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {

double divergence(const Eigen::Ref<const Eigen::ArrayXd>& q, const Eigen::Ref<const Eigen::ArrayXd>& w) {
  const PairOfSums sums =
      click_kernels().divergence(q.data(), w.data(), std::numeric_limits<double>::max(), w.size());
  return sums.first + sums.second;
}

double model_cost(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, int block) {
  const PairOfSums sums = click_kernels().divergence(q.data(), v.data(), kOutlierClip, v.size());
  return 0.5 * block * (sums.first + sums.second);
}

std::vector<long> onsets_in_blocks(const std::vector<int>& P, int block) {
  std::vector<long> onsets;
  for (const int sample : P) onsets.push_back(sample / block);
  return onsets;
}

void set_first_powers(const Eigen::ArrayXd& q, ModelClicks& clicks) {
  clicks.power =
      Eigen::ArrayXd::Constant(static_cast<long>(clicks.onset.size()), 3 * std::max(q.mean(), 1e-3));
  clicks.floor = std::max(1e-4, 0.5 * quantile(std::vector<double>(q.begin(), q.end()), 0.1));
}

void model_variance(const TrainPower& train, const ModelClicks& clicks, Eigen::ArrayXd& v) {
  train.spread(clicks.power, clicks.floor, v);
  if (clicks.others.size() > 0) v += clicks.others;
}

Eigen::ArrayXd model_variance(const EnvelopePower& shape, const ModelClicks& clicks, long length) {
  Eigen::ArrayXd v;
  model_variance(TrainPower(shape, clicks.onset, length), clicks, v);
  return v;
}

void update_powers(const Eigen::ArrayXd& q, const TrainPower& train, int sweeps, double clip,
                   ModelClicks& clicks) {
  Eigen::ArrayXd v;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    model_variance(train, clicks, v);
    const TrainSums sums = train.weigh(q, v, clip);
    const Eigen::ArrayXd ratio = (sums.x + 1e-30) / (sums.y + 1e-30);
    if (sweep == 0)
      clicks.power *= ratio;
    else
      clicks.power *= ratio.sqrt();
    clicks.floor *= std::sqrt(sums.all.first / sums.all.second);
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
