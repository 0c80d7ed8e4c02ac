#include "bank/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "bank/click_masks.hpp"
#include "clicks/gaps.hpp"
#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kWholeEnough = 0.6;  // of the click length before the end of the signal

}  // namespace

std::vector<ClickCandidate> click_candidates(const Segments& segments) {
  std::vector<ClickCandidate> candidates;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& [P, beta, shape, T_0] = segments[s].result.clicks;
    const std::vector<float> x = segments[s].result.drilling.all();
    const ClickMasks masks(segments[s].result.clicks, static_cast<long>(x.size()));
    const double period = median_gap(P);
    const std::size_t first = std::max<std::size_t>(segments[s].first, 1);
    for (std::size_t i = first; i < segments[s].last && i + 1 < P.size(); ++i) {
      if (P[i] + kWholeEnough * masks.click_length() >= static_cast<double>(x.size())) continue;
      const std::vector<float> click = masks.extract(x, i);
      const double energy = dsp::energy(click);
      if (energy <= 0) continue;
      const double louder = std::max(beta[i - 1], beta[i + 1]);
      candidates.push_back(
          {s, i, std::sqrt(energy), (P[i + 1] - P[i]) / period, beta[i] / std::max(louder, 1e-9)});
    }
  }
  return candidates;
}

}  // namespace rigsound::analysis
