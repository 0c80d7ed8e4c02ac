#include "clicks/heard_band.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kFirstOfClick_s = 0.012, kFirstOfGap = 0.4;
constexpr float kHeardAbove = 1e-6F;   // of the loudest bin
constexpr double kMayBeMissing = 0.1;  // of the clicks

double share_missing(const PowerSpectrogram& power, const ClickFrames& clicks, long bin, float least) {
  const auto missing = std::count_if(clicks.onset.begin(), clicks.onset.end(), [&](long onset) {
    return power.P.row(bin).segment(onset, clicks.length).mean() < least;
  });
  return static_cast<double>(missing) / static_cast<double>(clicks.onset.size());
}

}  // namespace

ClickFrames click_frames(const ClickTrain& clicks, long frames) {
  ClickFrames found;
  const double longest = std::min(kFirstOfGap * clicks.mean_gap_samples, kFirstOfClick_s * kAnalysisRate);
  found.length = std::max(2L, static_cast<long>(longest / kChainStft.hop));
  for (const int P : clicks.P) {
    const long frame = std::lround(static_cast<double>(P) / kChainStft.hop);
    if (frame >= kBeforeFrom && frame + found.length <= frames) found.onset.push_back(frame);
  }
  return found;
}

long heard_bins(const PowerSpectrogram& power, const ClickFrames& clicks) {
  if (clicks.onset.empty()) return power.bins();
  const float least = kHeardAbove * power.P.leftCols(power.frames).rowwise().mean().maxCoeff();
  long bins = power.bins();
  while (bins > 1 && share_missing(power, clicks, bins - 1, least) > kMayBeMissing) --bins;
  return bins;
}

}  // namespace rigsound::analysis
