#include "spectrum/power_spectrogram.hpp"

#include "kernels/is_kernels.hpp"

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

Eigen::ArrayXd mean_power(const PowerSpectrogram& power) {
  return power.P.leftCols(power.frames).cast<double>().rowwise().mean();
}

PowerSpectrogram frames_between(const PowerSpectrogram& power, int first, int last) {
  PowerSpectrogram part;
  part.frames = last - first;
  part.P = power.P.middleCols(first, part.frames);
  part.scale = power.scale;
  return part;
}

}  // namespace rigsound::analysis
