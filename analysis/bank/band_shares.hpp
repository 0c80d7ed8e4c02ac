// The spectrum of a click, coarse enough to be compared with that of another.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace rigsound::analysis {

/// Energies of a click in log-spaced bands between 47 Hz and 24 kHz, as shares of the whole. Thread: OFF.
class BandShares {
 public:
  static constexpr int kBands = 24;
  using Shares = Eigen::Array<double, kBands, 1>;

  BandShares();
  Shares operator()(const std::vector<float>& click);

 private:
  Eigen::FFT<double> fft_;
  Eigen::VectorXd frame_;
  Eigen::VectorXcd bins_;
  std::vector<int> edges_;
};

}  // namespace rigsound::analysis
