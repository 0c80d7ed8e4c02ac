#include "tool_fit/partials.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"
#include "tool_fit/impact_sound.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kSize = 1 << 16, kSkip = kBeforeImpact + 192, kMost = 24;
constexpr double kLowest_hz = 60, kProminence_db = 9;

/// dB per bin; a half-Gaussian window, so that a decaying partial has one peak and no side lobes.
std::vector<double> spectrum_db(const std::vector<double>& impact) {
  std::vector<double> x(kSize, 0.0);
  const std::size_t length = std::min(kSize, impact.size() - kSkip);
  for (std::size_t i = 0; i < length; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(length);
    x[i] = impact[kSkip + i] * std::exp(-8 * t * t);
  }
  std::vector<std::complex<double>> X;
  Eigen::FFT<double>().fwd(X, x);
  std::vector<double> level;
  for (std::size_t k = 0; k < kSize / 2; ++k) level.push_back(10 * std::log10(std::norm(X[k]) + 1e-30));
  return level;
}

double median_around(const std::vector<double>& level, std::size_t k) {
  const std::size_t reach = std::max<std::size_t>(100, k / 8);
  return upper_median(
      std::vector<double>(level.begin() + static_cast<std::ptrdiff_t>(k > reach ? k - reach : 0),
                          level.begin() + static_cast<std::ptrdiff_t>(std::min(level.size(), k + reach))));
}

}  // namespace

std::vector<Partial> clear_partials(const std::vector<double>& impact, double highest_hz) {
  if (impact.size() < kSkip + 1024) return {};
  const std::vector<double> level = spectrum_db(impact);
  const double hz_a_bin = kAnalysisRate / kSize;
  std::vector<Partial> partials;
  const auto end = std::min(level.size() - 2, static_cast<std::size_t>(highest_hz / hz_a_bin));
  for (auto k = static_cast<std::size_t>(kLowest_hz / hz_a_bin); k < end; ++k) {
    const double a = level[k - 1], b = level[k], c = level[k + 1];
    if (!(b > a && b >= c)) continue;
    const double prominence = b - median_around(level, k);
    if (prominence < kProminence_db) continue;
    const double offset = 0.5 * (a - c) / (a - 2 * b + c);
    partials.push_back({(static_cast<double>(k) + offset) * hz_a_bin, prominence});
  }
  std::sort(partials.begin(), partials.end(),
            [](const Partial& p, const Partial& q) { return p.prominence_db > q.prominence_db; });
  if (partials.size() > kMost) partials.resize(kMost);
  return partials;
}

}  // namespace rigsound::analysis
