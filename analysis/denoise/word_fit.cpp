#include "denoise/word_fit.hpp"

#include <algorithm>
#include <vector>

#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kQuietOfNoise = 0.223f;  // the 20 % quantile of an exponential distribution, of its mean

/// kLanes bins from `first` on, frame after frame; what is beyond the last bin repeats it.
void lay_side_by_side(const PowerSpectrogram& power, int first, float* to) {
  for (int from = 0; from < power.frames; from += kLanes)  // as many frames as the first-level cache holds
    for (int lane = 0; lane < kLanes; ++lane) {
      const float* row = power.P.row(std::min(first + lane, power.bins() - 1)).data();
      for (int n = from; n < std::min(from + kLanes, power.frames); ++n) to[n * kLanes + lane] = row[n];
    }
}

}  // namespace

WordFit::WordFit(const PowerSpectrogram& power) : power_(&power), mean_(power.bins()), quiet_(power.bins()) {
  const long groups = (power.bins() + kLanes - 1) / kLanes, size = static_cast<long>(power.frames) * kLanes;
  side_by_side_.resize(groups * size);
  for (int group = 0; group < groups; ++group)
    lay_side_by_side(power, group * kLanes, side_by_side_.data() + group * size);
  for (int m = 0; m < power.bins(); ++m) {
    const auto row = power.P.row(m).head(power.frames);
    mean_(m) = row.mean();
    quiet_(m) = quantile(std::vector<float>(row.data(), row.data() + row.size()), 0.2) / kQuietOfNoise;
  }
}

void WordFit::update(const Updates& updates, const float* cost, Factors& f) const {
  const Activations H{f.H.data(), static_cast<int>(f.H.rows()), static_cast<int>(f.H.cols()), cost};
  for (int m = 0; m < power_->bins(); m += kLanes) {
    const float* P = side_by_side_.data() + static_cast<long>(m) * power_->frames;
    is_kernels().fit_bins({P, power_->frames, f.W.row(m).data(), std::min(kLanes, power_->bins() - m)}, H,
                          updates, kWordFloor);
  }
}

}  // namespace rigsound::analysis
