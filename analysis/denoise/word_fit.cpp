#include "denoise/word_fit.hpp"

#include <algorithm>

namespace rigsound::analysis {

WordFit::WordFit(const PowerSpectrogram& power) : frames_(power.frames), bins_(power.bins()) {
  const int padded = (bins_ + kLanes - 1) / kLanes * kLanes;
  side_by_side_.resize(static_cast<std::size_t>(padded) * static_cast<std::size_t>(frames_));
  for (int m = 0; m < padded; ++m) {  // what is beyond the last bin repeats it
    const float* row = power.P.row(std::min(m, bins_ - 1)).data();
    float* to = side_by_side_.data() + static_cast<long>(m / kLanes) * frames_ * kLanes + m % kLanes;
    for (int n = 0; n < frames_; ++n) to[n * kLanes] = row[n];
  }
}

void WordFit::update(const Updates& updates, const float* cost, Factors& f) const {
  const Activations H{f.H.data(), static_cast<int>(f.H.rows()), static_cast<int>(f.H.cols()), cost};
  for (int m = 0; m < bins_; m += kLanes) {
    const float* P = side_by_side_.data() + static_cast<long>(m) * frames_;
    is_kernels().fit_bins({P, frames_, f.W.row(m).data(), std::min(kLanes, bins_ - m)}, H, updates,
                          kWordFloor);
  }
}

}  // namespace rigsound::analysis
