#include "denoise/factors.hpp"

#include <algorithm>
#include <vector>

#include "kernels/is_kernels.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kAudiblePower = 1e-5f;  // of the loudest bin's power
constexpr float kModelFloor = 1e-12f;
constexpr float kSilenced = 0.01f;  // of a bin's mean error

}  // namespace

Eigen::ArrayXf noise_level(const PowerSpectrogram& power, float start) {
  Eigen::ArrayXf level(power.bins());
  for (int m = 0; m < power.bins(); ++m) {
    const auto row = power.P.row(m).head(power.frames);
    level(m) =
        std::min(start * quantile(std::vector<float>(row.data(), row.data() + row.size()), 0.2) / 0.223f,
                 0.9f * row.mean());
  }
  return level;
}

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
  Grid S(power.bins(), power.padded()), N(power.bins(), power.padded());
  for (int m = 0; m < power.bins(); ++m) {
    const float* w = factors.W.row(m).data();
    is_kernels().model_bin(signal, w, factors.signal_words, S.row(m).data());
    is_kernels().model_bin(noise, w + factors.signal_words, noise_words, N.row(m).data());
  }
  const float scale = static_cast<float>(power.scale);
  return {S.leftCols(power.frames) * scale, N.leftCols(power.frames) * scale};
}

Spectrogram wiener(const Spectrogram& X, const PsdPair& psd) {
  Grid gain = psd.S / (psd.S + psd.N).max(1e-30f);
  const Grid held = psd.S * gain;
  // A gain lowered by the share d costs S G d^2 more error: d = c / (S G + c) at most c / 4.
  const Eigen::ArrayXf c = kSilenced * (psd.N * gain).rowwise().mean();
  gain *= held / (held.colwise() + c).max(1e-30f);
  return X * gain.cast<std::complex<float>>();
}

Grid itakura_saito(const PowerSpectrogram& power, const Factors& factors) {
  const PsdPair psd = modelled_psd(factors, power);
  const Grid L = (psd.S + psd.N) / static_cast<float>(power.scale);
  const Grid ratio = power.P.leftCols(power.frames) / L.max(kModelFloor);
  return ratio - ratio.log() - 1;
}

double mean_divergence(const PowerSpectrogram& power, const Grid& divergence, const Eigen::ArrayXf& weight,
                       long bins) {
  const Eigen::ArrayXf mean = power.P.topRows(bins).rowwise().mean();
  const Eigen::ArrayXd audible = (mean > kAudiblePower * mean.maxCoeff()).cast<double>();
  const Eigen::ArrayXd by_bin = (divergence.topRows(bins).matrix() * weight.matrix()).cast<double>().array() /
                                std::max(1.0f, weight.sum());
  return (by_bin * audible).sum() / audible.sum();
}

}  // namespace rigsound::analysis
