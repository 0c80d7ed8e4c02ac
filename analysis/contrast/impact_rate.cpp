#include "contrast/impact_rate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unsupported/Eigen/FFT>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/butterworth.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kHop = 12;  // 0.25 ms
constexpr double kHopRate = kAnalysisRate / kHop;
constexpr double kHighpass_hz = 1000;
constexpr int kRise = 4;  // hops over which an onset is a difference
constexpr int kMultiples = 3;
constexpr double kNearlyMost = 0.55;          // half a period has a third of it
constexpr double kRegular = 0.1;              // peak below which nothing comes back
constexpr double kBlur = 0.05, kPeak = 0.12;  // of a lag: what gaps scatter; what belongs to a peak

/// How much louder it has become, hop by hop, never negative.
Eigen::VectorXd onsets(const std::vector<float>& x) {
  dsp::Butterworth6 high(dsp::Pass::kHigh, kHighpass_hz, kAnalysisRate);
  const auto hops = static_cast<long>(x.size()) / kHop;
  Eigen::VectorXd level(hops), rise = Eigen::VectorXd::Zero(hops);
  for (long i = 0; i < hops; ++i) {
    double sum = 0;
    for (int n = 0; n < kHop; ++n) {
      const double y = high.process(static_cast<double>(x[static_cast<std::size_t>(i * kHop + n)]));
      sum += y * y;
    }
    level(i) = std::sqrt(std::sqrt(sum));  // loud impacts count more, but not only they
  }
  for (long i = kRise; i < hops; ++i) rise(i) = std::max(0.0, level(i) - level(i - kRise));
  return rise.array() - rise.mean();
}

/// Autocorrelation at lags 0...highest, 1 at lag 0, as if the sound went on for ever.
Eigen::ArrayXd autocorrelation(const Eigen::VectorXd& x, long highest) {
  long size = 1;
  while (size < x.size() + highest) size *= 2;
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(size);
  padded.head(x.size()) = x;
  Eigen::FFT<double> fft;
  Eigen::VectorXcd bins;
  fft.fwd(bins, padded);
  const Eigen::VectorXcd power = bins.array().abs2().cast<std::complex<double>>();
  fft.inv(padded, power);
  Eigen::ArrayXd r = padded.head(highest + 1);
  for (long lag = 0; lag <= highest; ++lag) r(lag) /= static_cast<double>(x.size() - lag);
  return r(0) > 0 ? Eigen::ArrayXd(r / r(0)) : Eigen::ArrayXd::Zero(highest + 1);
}

/// Triangular sum over +- kBlur of each lag: what scatter has spread comes together again.
Eigen::ArrayXd blurred(const Eigen::ArrayXd& r) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(r.size());
  for (long lag = 1; lag < r.size(); ++lag) {
    const long reach = std::max<long>(2, std::lround(kBlur * static_cast<double>(lag)));
    for (long k = std::max<long>(-reach, 1 - lag); k <= std::min(reach, r.size() - 1 - lag); ++k)
      sum(lag) += r(lag + k) * (1 - static_cast<double>(std::abs(k)) / static_cast<double>(reach + 1));
  }
  return sum;
}

/// How much of `peaks` stands at a lag and its next multiples: an echo of each impact stands there only once.
double support(const Eigen::ArrayXd& peaks, long lag) {
  double sum = 0;
  for (long k = 1; k <= kMultiples && k * lag < peaks.size(); ++k) sum += peaks(k * lag) / kMultiples;
  return sum;
}

/// The shortest lag with nearly the most support; the others are its multiples. 0: there is none.
long period_of(const Eigen::ArrayXd& peaks, long shortest, long longest) {
  std::vector<long> candidates;
  double most = 0;
  for (long lag = shortest; lag < std::min<long>(longest, peaks.size() - 1); ++lag) {
    if (peaks(lag) <= 0 || peaks(lag) < peaks(lag - 1) || peaks(lag) <= peaks(lag + 1)) continue;
    candidates.push_back(lag);
    most = std::max(most, support(peaks, lag));
  }
  for (const long lag : candidates)
    if (support(peaks, lag) >= kNearlyMost * most) return lag;
  return 0;
}

}  // namespace

double impact_rate_hz(const std::vector<float>& x) {
  const auto shortest = static_cast<long>(kHopRate / kHighestRate_hz),
             longest = static_cast<long>(kHopRate / kLowestRate_hz);
  const Eigen::VectorXd rises = onsets(x);
  const Eigen::ArrayXd r = autocorrelation(rises, std::min<long>(kMultiples * longest, rises.size() / 2));
  const Eigen::ArrayXd peaks = blurred(r);
  const long period = period_of(peaks, shortest, longest);
  if (period == 0 || peaks(period) < kRegular) return 0;
  const long from = std::lround((1 - kPeak) * static_cast<double>(period)),
             to = std::min<long>(std::lround((1 + kPeak) * static_cast<double>(period)), r.size() - 1);
  double weight = 0, moment = 0;
  for (long lag = from; lag <= to; ++lag)
    if (r(lag) > 0) weight += r(lag), moment += r(lag) * static_cast<double>(lag);
  return kHopRate * weight / moment;
}

}  // namespace rigsound::analysis
