#include "mix/true_peak.hpp"

#include <algorithm>
#include <iterator>

#include "rigsound/dsp/passes.hpp"

namespace rigsound::mix {
namespace {

constexpr int kGroup = 8;  // frames that are looked at together, by highest_of_eights()
static_assert(TruePeak::kPast == 2 * kGroup && TruePeak::kPast >= kTruePeakTaps - 1);

double highest(dsp::Lanes x) noexcept { return std::max(x[0], x[1]); }

/// Twice the higher of a phase and its mirror image: with s and d the sum and the difference of the two,
/// max(|a|, |b|) = (|s| + |d|) / 2. `sum` and `difference`: of x[-k] and x[k - 11].
dsp::Lanes mirrored_pair(const double* h, const dsp::Lanes* sum, const dsp::Lanes* difference) noexcept {
  dsp::Lanes s{}, d{};
  for (int k = 0; k < kTruePeakTaps / 2; ++k) {
    const double mirror = h[kTruePeakTaps - 1 - k];
    s += (h[k] + mirror) * sum[k];
    d += (h[k] - mirror) * difference[k];
  }
  return dsp::magnitude(s) + dsp::magnitude(d);
}

double true_peak(const dsp::Lanes* x) noexcept {
  dsp::Lanes most{};
  for (int n = 0; n < kGroup; ++n) {
    dsp::Lanes sum[kTruePeakTaps / 2], difference[kTruePeakTaps / 2];
    for (int k = 0; k < kTruePeakTaps / 2; ++k) {
      const dsp::Lanes newer = x[n - k], older = x[n - (kTruePeakTaps - 1) + k];
      sum[k] = newer + older, difference[k] = newer - older;
    }
    for (const auto& phase : kTruePeakPhase) most = dsp::larger(most, mirrored_pair(phase, sum, difference));
  }
  return highest(most) / 2;
}

}  // namespace

double TruePeak::of(const dsp::Lanes* x, double least) noexcept {
  double peak[2 + kChunk / kGroup] = {past_[0], past_[1]};
  dsp::with_widest<dsp::Passes>([&](auto passes) { passes.highest_of_eights(x, kChunk, peak + 2); });
  double most = *std::max_element(peak + 2, std::end(peak));
  const double most_reach = std::max({most, past_[0], past_[1]});
  past_[0] = peak[kChunk / kGroup], past_[1] = peak[1 + kChunk / kGroup];
  if (kTruePeakSpread * most_reach <= std::max(least, most)) return most;
  for (int g = 0; g < kChunk / kGroup; ++g) {
    const double reach = std::max({peak[g], peak[g + 1], peak[g + 2]});
    if (kTruePeakSpread * reach > std::max(least, most)) most = std::max(most, true_peak(x + g * kGroup));
  }
  return most;
}

}  // namespace rigsound::mix
