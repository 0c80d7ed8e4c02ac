#include "bank/click_choice.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "bank/band_shares.hpp"
#include "bank/click_extraction.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kPoolShare = 0.6;
constexpr std::size_t kMostPool = 20000;  // clicks, of a quarter of an hour
constexpr double kBandFloor = 1e-6;       // share of the energy below which a band does not matter

double room(const ClickCandidate& c) { return std::min(c.gap, 1.5) + 0.5 * std::min(c.prominence, 1.5); }

BandShares::Shares decibels(const BandShares::Shares& shares) { return 10 * (shares + kBandFloor).log10(); }

/// Indices of `candidates` in the order of `before`, ties in the order of time.
template <class Before>
std::vector<std::size_t> ordered(const std::vector<ClickCandidate>& candidates, Before before) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(candidates[a], candidates[b]); });
  return order;
}

/// The best, by room and prominence.
std::vector<std::size_t> pool_of(const std::vector<ClickCandidate>& candidates, std::size_t count) {
  std::vector<std::size_t> pool =
      ordered(candidates, [](const auto& a, const auto& b) { return room(a) > room(b); });
  const auto share = static_cast<std::size_t>(kPoolShare * static_cast<double>(pool.size()));
  pool.resize(std::min(pool.size(), std::max(count, std::min(share, kMostPool))));
  return pool;
}

/// Spectra of the clicks of a pool, in its order, and the mean over all clicks.
struct PoolSpectra {
  std::vector<BandShares::Shares> of_pool;
  BandShares::Shares mean = BandShares::Shares::Zero();
};

PoolSpectra spectra_of(const Segments& segments, const std::vector<ClickCandidate>& candidates,
                       const std::vector<std::size_t>& pool) {
  constexpr std::size_t kOutside = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place(candidates.size(), kOutside);
  for (std::size_t i = 0; i < pool.size(); ++i) place[pool[i]] = i;
  PoolSpectra spectra;
  spectra.of_pool.resize(pool.size());
  const auto count_in = [&](std::size_t i, const BandShares::Shares& shares) {
    spectra.mean += shares / static_cast<double>(candidates.size());
    if (place[i] != kOutside) spectra.of_pool[place[i]] = shares;
  };
  BandShares band_shares;
  std::size_t waiting = 0;
  std::vector<float> held;  // until there are two
  std::vector<std::size_t> all(candidates.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for_each_click(segments, candidates, all, [&](std::size_t i, std::vector<float> click) {
    if (held.empty()) {
      waiting = i, held = std::move(click);
      return;
    }
    const auto shares = band_shares(held, click);
    count_in(waiting, shares[0]), count_in(i, shares[1]);
    held.clear();
  });
  if (!held.empty()) count_in(waiting, band_shares(held, {})[0]);
  return spectra;
}

}  // namespace

std::vector<std::size_t> choose_by_cover(const Segments& segments,
                                         const std::vector<ClickCandidate>& candidates, std::size_t count) {
  const std::vector<std::size_t> pool = pool_of(candidates, count);
  const PoolSpectra spectra = spectra_of(segments, candidates, pool);
  const BandShares::Shares target = decibels(spectra.mean);
  BandShares::Shares sum = BandShares::Shares::Zero();
  std::vector<std::size_t> left(pool.size()), chosen;
  std::iota(left.begin(), left.end(), std::size_t{0});
  while (chosen.size() < count && !left.empty()) {
    const double size = static_cast<double>(chosen.size()) + 1;
    double best = std::numeric_limits<double>::infinity();
    auto nearest = left.begin();
    for (auto it = left.begin(); it != left.end(); ++it) {
      const double distance = (decibels((sum + spectra.of_pool[*it]) / size) - target).square().sum();
      if (distance < best) best = distance, nearest = it;
    }
    sum += spectra.of_pool[*nearest];
    chosen.push_back(pool[*nearest]);
    left.erase(nearest);
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
