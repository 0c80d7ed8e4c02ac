#include "bank/click_choice.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rigsound::analysis {
namespace {

constexpr double kPoolShare = 0.6;
constexpr double kBandFloor = 1e-6;  // share of the energy below which a band does not matter

double room(const ClickCandidate& c) { return std::min(c.gap, 1.5) + 0.5 * std::min(c.prominence, 1.5); }

Eigen::ArrayXd decibels(const Eigen::ArrayXd& shares) { return 10 * (shares + kBandFloor).log10(); }

/// Indices of `candidates` in the order of `before`, ties in the order of time.
template <class Before>
std::vector<std::size_t> ordered(const std::vector<ClickCandidate>& candidates, Before before) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(candidates[a], candidates[b]); });
  return order;
}

}  // namespace

std::vector<std::size_t> choose_by_cover(const std::vector<ClickCandidate>& candidates, std::size_t count) {
  std::vector<std::size_t> pool =
      ordered(candidates, [](const auto& a, const auto& b) { return room(a) > room(b); });
  const auto share = static_cast<std::size_t>(kPoolShare * static_cast<double>(pool.size()));
  pool.resize(std::min(pool.size(), std::max(count, share)));

  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(kCoverBands), sum = mean;
  for (const ClickCandidate& c : candidates) mean += c.bands / static_cast<double>(candidates.size());
  const Eigen::ArrayXd target = decibels(mean);

  std::vector<std::size_t> chosen;
  while (chosen.size() < count && !pool.empty()) {
    const double size = static_cast<double>(chosen.size()) + 1;
    double best = std::numeric_limits<double>::infinity();
    auto nearest = pool.begin();
    for (auto it = pool.begin(); it != pool.end(); ++it) {
      const double distance = (decibels((sum + candidates[*it].bands) / size) - target).square().sum();
      if (distance < best) best = distance, nearest = it;
    }
    sum += candidates[*nearest].bands;
    chosen.push_back(*nearest);
    pool.erase(nearest);
  }
  return chosen;
}

std::vector<std::size_t> choose_by_room(const std::vector<ClickCandidate>& candidates, std::size_t count) {
  std::vector<std::size_t> order = ordered(candidates, [](const auto& a, const auto& b) {
    const bool a_louder = a.prominence > 1, b_louder = b.prominence > 1;
    return a_louder != b_louder ? a_louder : a.gap > b.gap;
  });
  order.resize(std::min(order.size(), count));
  return order;
}

}  // namespace rigsound::analysis
