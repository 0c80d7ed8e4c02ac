#include "spectrum/stft.hpp"

#include <algorithm>

#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kSideBySide = 16;  // frames: a bin's course in time is written a cache line at a time

long frames_of(const std::vector<float>& x, const StftShape& shape) {
  return (static_cast<long>(x.size()) + shape.hop - 1) / shape.hop;
}

/// Frame i of x under the window, zeros where there is none.
void put_frame(const std::vector<float>& x, long i, const StftShape& shape, const Eigen::ArrayXf& window,
               float* to) {
  const long size = static_cast<long>(x.size()), start = i * shape.hop - shape.window / 2;
  const long first = std::clamp(start, 0L, size), last = std::clamp(start + shape.window, first, size);
  std::fill(to, to + shape.fft, 0.0f);
  Eigen::Map<Eigen::ArrayXf>(to + (first - start), last - first) =
      Eigen::Map<const Eigen::ArrayXf>(x.data() + first, last - first) *
      window.segment(first - start, last - first);
}

}  // namespace

Eigen::ArrayXf hann(int length) {
  const double step = 2 * static_cast<double>(EIGEN_PI) / length;
  return (0.5 - 0.5 * (Eigen::ArrayXd::LinSpaced(length, 0, length - 1) * step).cos()).cast<float>();
}

Spectrogram stft(const std::vector<float>& x, const StftShape& shape) {
  const long frames = frames_of(x, shape);
  const Eigen::ArrayXf window = hann(shape.window);
  FramePair pair(shape.fft);
  Spectrogram X(shape.bins(), frames), block(shape.bins(), kSideBySide);
  for (long from = 0; from < frames; from += kSideBySide) {
    const long here = std::min(kSideBySide, frames - from);
    for (long i = 0; i < here; i += 2) {
      put_frame(x, from + i, shape, window, pair.first());
      put_frame(x, from + i + 1, shape, window, pair.second());
      pair.forward();
      for (int k = 0; k < shape.bins(); ++k)
        block(k, i) = pair.first_bin(k), block(k, i + 1) = pair.second_bin(k);
    }
    X.middleCols(from, here) = block.leftCols(here);
  }
  return X;
}

Eigen::ArrayXd mean_power(const std::vector<float>& x, const StftShape& shape) {
  const long frames = frames_of(x, shape);
  const Eigen::ArrayXf window = hann(shape.window);
  FramePair pair(shape.fft);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(shape.bins());
  for (long i = 0; i < frames; i += 2) {
    put_frame(x, i, shape, window, pair.first());
    if (i + 1 < frames)
      put_frame(x, i + 1, shape, window, pair.second());
    else
      std::fill(pair.second(), pair.second() + shape.fft, 0.0f);
    pair.forward();
    for (int k = 0; k < shape.bins(); ++k) sum(k) += static_cast<double>(pair.power(k));
  }
  return sum / static_cast<double>(frames);
}

std::vector<float> inverse_stft(const Spectrogram& X, size_t length, const StftShape& shape) {
  const long margin = shape.window / 2, frames = X.cols();
  const Eigen::ArrayXf window = hann(shape.window), squared = window.square();
  Eigen::ArrayXf sum = Eigen::ArrayXf::Zero(frames * shape.hop + shape.window), weight = sum;
  FramePair pair(shape.fft);
  const auto add = [&](long i, const float* frame) {
    sum.segment(i * shape.hop, shape.window) +=
        Eigen::Map<const Eigen::ArrayXf>(frame, shape.window) * window;
    weight.segment(i * shape.hop, shape.window) += squared;
  };
  for (long i = 0; i < frames; i += 2) {
    const bool alone = i + 1 == frames;
    for (int k = 0; k < shape.bins(); ++k) pair.set_bins(k, X(k, i), alone ? 0 : X(k, i + 1));
    pair.inverse();
    add(i, pair.first());
    if (!alone) add(i + 1, pair.second());
  }
  sum /= weight.max(1e-3f * weight.maxCoeff());
  std::vector<float> y(length);
  Eigen::Map<Eigen::ArrayXf>(y.data(), static_cast<long>(length)) =
      sum.segment(margin, static_cast<long>(length));
  return y;
}

}  // namespace rigsound::analysis
