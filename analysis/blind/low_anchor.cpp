#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/blind_sounds.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kPassed_hz = 3500, kStopped_hz = 4000;

/// A half period of a cosine between what passes and what is stopped.
double anchor_gain(double hz) {
  const double at = std::clamp((hz - kPassed_hz) / (kStopped_hz - kPassed_hz), 0.0, 1.0);
  return 0.5 * (1 + std::cos(dsp::kPi * at));
}

}  // namespace

std::vector<float> low_anchor(const std::vector<float>& x) {
  constexpr std::size_t kRinging = 8192;  // samples, into which the filter rings at either end
  std::size_t size = 1;
  while (size < x.size() + kRinging) size *= 2;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<long>(size));
  std::copy(x.begin(), x.end(), y.data());
  Eigen::VectorXcd bins;
  fft.fwd(bins, y);
  for (long k = 0; k < bins.size(); ++k)
    bins(k) *= anchor_gain(static_cast<double>(k) * kAnalysisRate / static_cast<double>(size));
  fft.inv(y, bins, static_cast<long>(size));
  const Eigen::VectorXf out = y.head(static_cast<long>(x.size())).cast<float>();
  return {out.data(), out.data() + out.size()};
}

}  // namespace rigsound::analysis
