#include "clicks/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "clicks/independent_share.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

struct Windows {
  double forward_ms, backward_ms;
};
// The last where few samples are independent: 4 ms of modes below 1 kHz are eight of them.
constexpr Windows kWindows[] = {{2, 3}, {4, 4}, {8, 8}};
constexpr double kNarrow = 0.15;  // independent share
constexpr double kHeight = 1.5, kDistance_ms = 1;
constexpr double kPowerFloor = 1e-2;  ///< of the mean: digital silence must not make every ripple a step

long blocks_of(double ms) { return std::max(2L, std::lround(ms * kAnalysisRate / 1000 / kCandidateBlock)); }

}  // namespace

Eigen::ArrayXd block_mean(const Eigen::ArrayXd& x, int block) {
  return Eigen::Map<const Eigen::ArrayXXd>(x.data(), block, x.size() / block).colwise().mean();
}

Eigen::ArrayXd block_power(const Eigen::ArrayXd& y, int block) { return block_mean(y.square(), block); }

double step_statistic(const Eigen::ArrayXd& cumulative, long t, long forward, long backward, int samples) {
  const long n_f = std::min(forward, cumulative.size() - 1 - t), n_b = std::min(backward, t);
  if (n_f < 2 || n_b < 2) return 0;
  const double v_f = (cumulative(t + n_f) - cumulative(t)) / static_cast<double>(n_f);
  const double v_b = (cumulative(t) - cumulative(t - n_b)) / static_cast<double>(n_b);
  if (v_f <= v_b) return 0;
  const double v = (cumulative(t + n_f) - cumulative(t - n_b)) / static_cast<double>(n_f + n_b);
  const double likelihood = static_cast<double>(n_f) * std::log(v / v_f) +
                            static_cast<double>(n_b) * std::log(v / std::max(v_b, 1e-9 * v));
  return std::sqrt(std::max(samples * likelihood, 0.0));
}

std::vector<int> peaks(const Eigen::ArrayXd& z, double height, int distance) {
  std::vector<int> found;
  for (long n = 1; n + 1 < z.size(); ++n)
    if (z(n) >= height && z(n) > z(n - 1) && z(n) >= z(n + 1)) found.push_back(static_cast<int>(n));
  std::vector<size_t> highest(found.size());
  std::iota(highest.begin(), highest.end(), size_t{0});
  std::stable_sort(highest.begin(), highest.end(),
                   [&](size_t a, size_t b) { return z(found[a]) > z(found[b]); });
  std::vector<bool> gone(found.size());
  for (const size_t i : highest) {
    if (gone[i]) continue;
    for (size_t j = i; j-- > 0 && found[i] - found[j] < distance;) gone[j] = true;
    for (size_t j = i + 1; j < found.size() && found[j] - found[i] < distance; ++j) gone[j] = true;
  }
  std::vector<int> kept;
  for (size_t i = 0; i < found.size(); ++i)
    if (!gone[i]) kept.push_back(found[i]);
  return kept;
}

Candidates candidates_between(const Candidates& candidates, long first, long last) {
  Candidates inside;
  inside.z = candidates.z.segment(first, last - first);
  inside.narrow = candidates.narrow;
  for (const int block : candidates.block)
    if (block >= first && block < last) inside.block.push_back(block - static_cast<int>(first));
  return inside;
}

Candidates find_candidates(const Eigen::ArrayXd& y) {
  Eigen::ArrayXd power = block_power(y, kCandidateBlock);
  power += kPowerFloor * power.mean();
  Eigen::ArrayXd cumulative = Eigen::ArrayXd::Zero(power.size() + 1);
  std::partial_sum(power.begin(), power.end(), cumulative.begin() + 1);
  Candidates candidates;
  candidates.z = Eigen::ArrayXd::Zero(power.size());
  candidates.narrow = independent_share(y) < kNarrow;
  const int scales = candidates.narrow ? 3 : 2;
  for (int scale = 0; scale < scales; ++scale) {
    const long forward = blocks_of(kWindows[scale].forward_ms),
               backward = blocks_of(kWindows[scale].backward_ms);
    for (long t = 2; t + 2 < power.size(); ++t)
      candidates.z(t) =
          std::max(candidates.z(t), step_statistic(cumulative, t, forward, backward, kCandidateBlock));
  }
  candidates.block =
      peaks(candidates.z, kHeight, static_cast<int>(kDistance_ms * kAnalysisRate / 1000 / kCandidateBlock));
  return candidates;
}

}  // namespace rigsound::analysis
