#include "diesel/body_filter.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/fft.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kFloor = 1e-4;            // relative; keeps the poles below 0.9986
constexpr double kEdge = 0.92;             // of the source's Nyquist frequency: there its own filter begins
constexpr int kLong = 8192, kShort = 512;  // the short window fits between two impacts

/// Welch's mean of Hann-windowed periodograms over stretches that are open throughout.
std::vector<double> mean_spectrum(const std::vector<double>& x, const std::vector<char>& open, int size) {
  std::vector<double> power(static_cast<std::size_t>(size), 0.0), re(power.size()), im(power.size());
  const dsp::Fft<double> fft(size);
  const auto step = static_cast<std::size_t>(open.empty() ? size / 2 : size / 8);
  for (std::size_t at = 0; at + power.size() <= x.size(); at += step) {
    if (!open.empty()) {
      const auto begin = open.begin() + static_cast<std::ptrdiff_t>(at);
      if (std::find(begin, begin + size, 0) != begin + size) continue;
    }
    for (std::size_t i = 0; i < re.size(); ++i) {
      re[i] = x[at + i] * (0.5 - 0.5 * std::cos(2 * M_PI * static_cast<double>(i) / size));
      im[i] = 0;
    }
    fft.forward(re.data(), im.data());
    for (std::size_t i = 0; i < re.size(); ++i) power[i] += re[i] * re[i] + im[i] * im[i];
  }
  return power;
}

}  // namespace

std::vector<double> body_autocorrelation(const std::vector<double>& x, const std::vector<char>& open,
                                         double nyquist_hz, int order) {
  const int size = open.empty() ? kLong : kShort;
  std::vector<double> power = mean_spectrum(x, open, size), im(power.size(), 0.0);
  const auto edge = static_cast<std::size_t>(kEdge * nyquist_hz / kAnalysisRate * size);
  const std::size_t half = power.size() / 2;
  if (nyquist_hz < kAnalysisRate / 2 && edge < half) {
    const std::size_t width = edge / 16;
    double level = 0;
    for (std::size_t i = edge - width; i < edge; ++i) level += power[i] / static_cast<double>(width);
    for (std::size_t i = edge; i <= half; ++i) power[i] = power[power.size() - i] = level;
  }
  dsp::Fft<double>(size).inverse(power.data(), im.data());
  std::vector<double> r;
  for (int lag = 0; lag <= order; ++lag) r.push_back(power[lag] / (power[0] + 1e-300));
  r[0] = 1 + kFloor;
  return r;
}

std::vector<double> common_body(const std::vector<std::vector<double>>& autocorrelations) {
  std::vector<double> sum(autocorrelations.front().size(), 0.0);
  for (const std::vector<double>& r : autocorrelations)
    for (std::size_t lag = 0; lag < sum.size(); ++lag) sum[lag] += r[lag];
  return dsp::levinson(sum).a;
}

std::vector<double> whitened(const std::vector<double>& x, const std::vector<double>& A) {
  std::vector<double> e(x.size(), 0.0);
  for (std::size_t n = 0; n < x.size(); ++n)
    for (std::size_t k = 0; k < std::min(A.size(), n + 1); ++k) e[n] += A[k] * x[n - k];
  return e;
}

}  // namespace rigsound::analysis
