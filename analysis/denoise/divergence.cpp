#include "denoise/divergence.hpp"

#include <algorithm>

namespace rigsound::analysis {
namespace {

constexpr float kHeard = 1e-5f;  // of the loudest bin's power
constexpr float kModelFloor = 1e-12f;

}  // namespace

Grid itakura_saito(const PowerSpectrogram& power, const Factors& factors) {
  const PsdPair psd = modelled_psd(factors, power);
  const Grid L = (psd.S + psd.N) / static_cast<float>(power.scale);
  const Grid ratio = power.P.leftCols(power.frames) / L.max(kModelFloor);
  return ratio - ratio.log() - 1;
}

double mean_divergence(const PowerSpectrogram& power, const Factors& factors, const Eigen::ArrayXf& weight) {
  const Eigen::ArrayXf mean = power.P.rowwise().mean();
  const Eigen::ArrayXd heard = (mean > kHeard * mean.maxCoeff()).cast<double>();
  const Eigen::ArrayXd by_bin =
      (itakura_saito(power, factors).matrix() * weight.matrix()).cast<double>().array() /
      std::max(1.0f, weight.sum());
  return (by_bin * heard).sum() / heard.sum();
}

}  // namespace rigsound::analysis
