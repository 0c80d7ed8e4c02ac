#include "denoise/power.hpp"

#include <algorithm>
#include <vector>

#include "kernels/is_kernels.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kPowerFloor = 1e-7f;  ///< of the mean power

}  // namespace

PowerSpectrogram power_spectrogram(const Spectrogram& X) {
  const long frames = X.cols(), padded = (frames + kLanes - 1) / kLanes * kLanes;
  PowerSpectrogram power;
  power.frames = static_cast<int>(frames);
  power.P = Grid::Zero(X.rows(), padded);
  power.P.leftCols(frames) = X.abs2();
  power.scale = power.P.leftCols(frames).cast<double>().mean();
  power.P.leftCols(frames) = (power.P.leftCols(frames) / static_cast<float>(power.scale)).max(kPowerFloor);
  return power;
}

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

}  // namespace rigsound::analysis
