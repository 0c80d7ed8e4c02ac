#include "clicks/whitening.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>

#include "kernels/click_kernels.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kOrder = 192;  // 4 ms: a shorter filter lets hiss through that drowns clicks below 500 Hz
constexpr double kDrillingShare = 0.1;  ///< of S in D: 0 would be a pure matched filter
constexpr double kEmptyBin = 1e-6;      ///< of the largest power; band-limited files end here
constexpr double kLargestOverMedian = 1e4;
constexpr double kWhiteNoise = 1e-4;  ///< correction of r_0
constexpr double kLagWindow_hz = 60;  ///< Gaussian

/// D(f), with the bins that hold nothing set to the largest of the others.
Eigen::ArrayXd weight(const Eigen::ArrayXd& S, const Eigen::ArrayXd& N) {
  const Eigen::ArrayXd s = S.max(1e-12 * S.maxCoeff() + 1e-20), total = s + N;
  Eigen::ArrayXd D = (N + kDrillingShare * s) * total / s;
  std::vector<double> filled;
  for (long f = 0; f < D.size(); ++f)
    if (total(f) > kEmptyBin * total.maxCoeff()) filled.push_back(D(f));
  const double largest = *std::max_element(filled.begin(), filled.end());
  D = (total > kEmptyBin * total.maxCoeff()).select(D, largest);
  return D.min(kLargestOverMedian * upper_median(filled));
}

Eigen::ArrayXd autocorrelation(const Eigen::ArrayXd& power, int lags) {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  const Eigen::VectorXcd bins = power.matrix().cast<std::complex<double>>();
  Eigen::VectorXd r;
  fft.inv(r, bins, 2 * (power.size() - 1));
  return r.head(lags).array();
}

Eigen::ArrayXd prediction_error_filter(const Eigen::ArrayXd& r) {
  const std::vector<double> a = dsp::levinson({r.begin(), r.end()}).a;
  return Eigen::Map<const Eigen::ArrayXd>(a.data(), r.size());
}

}  // namespace

Eigen::ArrayXd noise_aware_whitener(const Eigen::ArrayXd& S, const Eigen::ArrayXd& N) {
  Eigen::ArrayXd r = autocorrelation(weight(S, N), kOrder + 1);
  const Eigen::ArrayXd lag_s = Eigen::ArrayXd::LinSpaced(kOrder + 1, 0, kOrder) / kAnalysisRate;
  r *= (-0.5 * (2 * EIGEN_PI * kLagWindow_hz * lag_s).square()).exp();
  r(0) *= 1 + kWhiteNoise;
  return prediction_error_filter(r);
}

Eigen::ArrayXd lpc_whitener(const std::vector<float>& x, int order) {
  const Eigen::ArrayXd signal =
      Eigen::Map<const Eigen::ArrayXf>(x.data(), static_cast<long>(x.size())).cast<double>();
  Eigen::ArrayXd r(order + 1);
  for (int lag = 0; lag <= order; ++lag)
    r(lag) = (signal.head(signal.size() - lag) * signal.tail(signal.size() - lag)).sum();
  return prediction_error_filter(r);
}

Eigen::ArrayXd whiten(const std::vector<float>& x, const Eigen::ArrayXd& A) {
  const long size = static_cast<long>(x.size()), before = A.size() - 1;
  const Eigen::ArrayXf taps = A.cast<float>();
  std::vector<float> silence_first(static_cast<std::size_t>(before));
  silence_first.insert(silence_first.end(), x.begin(), x.end());
  Eigen::ArrayXf filtered(size);
  click_kernels().filter(silence_first.data() + before, size, taps.data(), static_cast<int>(taps.size()),
                         filtered.data());
  const Eigen::ArrayXd y = filtered.cast<double>();
  return y / std::sqrt(std::max(y.square().mean(), 1e-30));
}

}  // namespace rigsound::analysis
