#include "spectrum/stft.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>

namespace rigsound::analysis {
namespace {

Eigen::FFT<float> transform() {
  Eigen::FFT<float> fft;
  fft.SetFlag(Eigen::FFT<float>::HalfSpectrum);
  return fft;
}

}  // namespace

Eigen::ArrayXf hann(int length) {
  const double step = 2 * static_cast<double>(EIGEN_PI) / length;
  return (0.5 - 0.5 * (Eigen::ArrayXd::LinSpaced(length, 0, length - 1) * step).cos()).cast<float>();
}

Spectrogram stft(const std::vector<float>& x, const StftShape& shape) {
  const long size = static_cast<long>(x.size());
  const long frames = (size + shape.hop - 1) / shape.hop;
  const Eigen::Map<const Eigen::ArrayXf> signal(x.data(), size);
  const Eigen::ArrayXf window = hann(shape.window);
  Eigen::FFT<float> fft = transform();
  Eigen::VectorXf frame(shape.fft);
  Eigen::VectorXcf bins(shape.bins());
  Spectrogram X(shape.bins(), frames);
  for (long i = 0; i < frames; ++i) {
    const long start = i * shape.hop - shape.window / 2;
    const long first = std::max(start, 0L), last = std::min(start + shape.window, size);
    frame.setZero();
    frame.segment(first - start, last - first) =
        signal.segment(first, last - first) * window.segment(first - start, last - first);
    fft.fwd(bins, frame);
    X.col(i) = bins;
  }
  return X;
}

std::vector<float> inverse_stft(const Spectrogram& X, size_t length, const StftShape& shape) {
  const long margin = shape.window / 2, frames = X.cols();
  const Eigen::ArrayXf window = hann(shape.window), squared = window.square();
  Eigen::ArrayXf sum = Eigen::ArrayXf::Zero(frames * shape.hop + shape.window), weight = sum;
  Eigen::FFT<float> fft = transform();
  Eigen::VectorXf frame(shape.fft);
  Eigen::VectorXcf bins(shape.bins());
  for (long i = 0; i < frames; ++i) {
    bins = X.col(i);
    fft.inv(frame, bins, shape.fft);
    sum.segment(i * shape.hop, shape.window) += frame.head(shape.window).array() * window;
    weight.segment(i * shape.hop, shape.window) += squared;
  }
  sum /= weight.max(1e-3f * weight.maxCoeff());
  std::vector<float> y(length);
  Eigen::Map<Eigen::ArrayXf>(y.data(), static_cast<long>(length)) =
      sum.segment(margin, static_cast<long>(length));
  return y;
}

}  // namespace rigsound::analysis
