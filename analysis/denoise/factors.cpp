#include "denoise/factors.hpp"

#include <algorithm>

#include "kernels/is_kernels.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kAudiblePower = 1e-5;  // of the loudest bin's power
constexpr float kModelFloor = 1e-12f;
constexpr float kSilenced = 0.01f;  // of a bin's mean error

}  // namespace

Grid hats(int knots, int frames, int padded) {
  Grid rows = Grid::Zero(knots, padded);
  if (knots == 1) rows.leftCols(frames) = 1;
  if (knots == 1) return rows;
  const auto position =
      Eigen::Array<float, 1, Eigen::Dynamic>::LinSpaced(frames, 0, static_cast<float>(knots - 1)).eval();
  for (int k = 0; k < knots; ++k)
    rows.row(k).head(frames) = (1 - (position - static_cast<float>(k)).abs()).max(0);
  return rows;
}

PsdPair modelled_psd(const Factors& factors, const PowerSpectrogram& power) {
  const int words = static_cast<int>(factors.W.cols()), noise_words = words - factors.signal_words;
  const Activations signal{factors.H.data(), factors.signal_words, power.padded()};
  const Activations noise{factors.H.row(factors.signal_words).data(), noise_words, power.padded()};
  const float scale = static_cast<float>(power.scale);
  PsdPair psd{Grid(power.bins(), power.frames), Grid(power.bins(), power.frames)};
  Grid row(1, power.padded());
  for (int m = 0; m < power.bins(); ++m) {
    const float* w = factors.W.row(m).data();
    is_kernels().model_bin(signal, w, factors.signal_words, row.data());
    psd.S.row(m) = row.leftCols(power.frames) * scale;
    is_kernels().model_bin(noise, w + factors.signal_words, noise_words, row.data());
    psd.N.row(m) = row.leftCols(power.frames) * scale;
  }
  return psd;
}

MeanPsd mean_psd(const Factors& factors, const PowerSpectrogram& power) {
  const Eigen::MatrixXd W = factors.W.cast<double>().matrix();
  const Eigen::VectorXd h =
      power.scale * factors.H.leftCols(power.frames).cast<double>().rowwise().mean().matrix();
  const long signal = factors.signal_words, noise = W.cols() - signal;
  return {(W.leftCols(signal) * h.head(signal)).array(), (W.rightCols(noise) * h.tail(noise)).array()};
}

Spectrogram wiener(const Spectrogram& X, const PsdPair& psd) {
  Spectrogram Y(X.rows(), X.cols());
  Grid gain(1, X.cols()), held(1, X.cols());
  for (long m = 0; m < X.rows(); ++m) {
    const auto S = psd.S.row(m), N = psd.N.row(m);
    gain = S / (S + N).max(1e-30f);
    held = S * gain;
    // A gain lowered by the share d costs S G d^2 more error: d = c / (S G + c) at most c / 4.
    const float c = kSilenced * (N * gain).mean();
    gain *= held / (held + c).max(1e-30f);
    Y.row(m) = X.row(m) * gain.cast<std::complex<float>>();
  }
  return Y;
}

Grid itakura_saito(const PowerSpectrogram& power, const Factors& factors) {
  const Activations H{factors.H.data(), static_cast<int>(factors.H.rows()), power.padded()};
  Grid divergence(power.bins(), power.frames), L(1, power.padded()), P = L, of_bin = L;
  for (int m = 0; m < power.bins(); ++m) {
    is_kernels().model_bin(H, factors.W.row(m).data(), H.words, L.data());
    L = L.max(kModelFloor);
    P = power.P.row(m).max(kModelFloor);  // the padding has no power
    is_kernels().divergence(P.data(), L.data(), power.padded(), of_bin.data());
    divergence.row(m) = of_bin.leftCols(power.frames);
  }
  return divergence;
}

Eigen::ArrayXd divergence_by_bin(const PowerSpectrogram& power, const Grid& divergence,
                                 const Eigen::ArrayXf& weight, long bins) {
  const Eigen::ArrayXd mean = mean_power(power).head(bins);
  const double least = kAudiblePower * mean.maxCoeff();
  Eigen::ArrayXd by_bin = (divergence.topRows(bins).matrix() * weight.matrix()).cast<double>().array() /
                          std::max(1.0f, weight.sum());
  long audible = 0;
  for (long m = 0; m < bins; ++m)
    if (mean(m) >= least) by_bin(audible++) = by_bin(m);
  return by_bin.head(audible);
}

}  // namespace rigsound::analysis
