#include "diesel/wavelet_tree.hpp"

#include <algorithm>
#include <cstring>

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/dsp/wavelet.hpp"

namespace rigsound::diesel {

WaveletTree::WaveletTree(int channels, int N, std::uint64_t seed)
    : channels_(channels),
      N_(N),
      width_(channels / kGroups),
      random_(seed, 43),
      approximation_(static_cast<std::size_t>(N * kPast * channels), 0.0),
      detail_(approximation_.size(), 0.0) {
  for (int g = 0; g < kGroups; ++g) count_.push_back(static_cast<std::uint64_t>(g & ((1 << N) - 1)));
}

void WaveletTree::produce(int group, const double* deviation, double* out) noexcept {
  level(group, 0, deviation, out);
  ++count_[static_cast<std::size_t>(group)];
}

void WaveletTree::reset() noexcept {
  std::fill(approximation_.begin(), approximation_.end(), 0.0);
  std::fill(detail_.begin(), detail_.end(), 0.0);
}

void WaveletTree::draw(int row, const double* deviation, double* out) noexcept {
  const double* sigma = deviation + row * width_;
  for (int i = 0; i < width_; ++i) out[i] = sigma[i] * random_.white(drawn_++, 0);
}

void WaveletTree::level(int group, int j, const double* deviation, double* out) noexcept {
  if (j == N_) return draw(N_, deviation, out);
  const int odd = static_cast<int>(count_[static_cast<std::size_t>(group)] >> j & 1);
  const auto at = [&](std::vector<double>& rows, int past) {
    return rows.data() +
           (static_cast<std::size_t>(j) * kPast + static_cast<std::size_t>(past)) *
               static_cast<std::size_t>(channels_) +
           group * width_;
  };
  if (!odd) {
    const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(width_);
    for (int past = kPast - 1; past > 0; --past) {
      std::memcpy(at(approximation_, past), at(approximation_, past - 1), bytes);
      std::memcpy(at(detail_, past), at(detail_, past - 1), bytes);
    }
    level(group, j + 1, deviation, at(approximation_, 0));
    draw(j, deviation, at(detail_, 0));
  }
  double h[kPast], g[kPast];
  for (int past = 0; past < kPast; ++past)
    h[past] = dsp::kDb4Scaling[2 * past + odd], g[past] = dsp::db4_wavelet(2 * past + odd);
  const double *a = at(approximation_, 0), *d = at(detail_, 0);
  for (int i = 0; i < width_; i += 2) {
    dsp::Lanes sum{};
    for (int past = 0; past < kPast; ++past)
      sum += h[past] * dsp::load(a + i + past * channels_) + g[past] * dsp::load(d + i + past * channels_);
    dsp::store(out + i, sum);
  }
}

}  // namespace rigsound::diesel
