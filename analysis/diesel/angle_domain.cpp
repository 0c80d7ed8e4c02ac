#include "diesel/angle_domain.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/dsp/interpolation_kernel.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kPhases = 1024;
constexpr int kDecimatorReach = 16;  // new samples on each side

std::vector<double> zero_phase(std::vector<double> x, dsp::Pass pass, double frequency_hz, double rate) {
  for (int direction = 0; direction < 2; ++direction) {
    dsp::Butterworth6 filter(pass, frequency_hz, rate);
    for (double& v : x) v = filter.process(v);
    std::reverse(x.begin(), x.end());
  }
  return x;
}

}  // namespace

std::vector<double> interpolated(const std::vector<double>& x, const std::vector<double>& positions,
                                 const Sinc& sinc) {
  const dsp::InterpolationKernel kernel(sinc.taps, kPhases, sinc.beta, sinc.bandwidth);
  const auto size = static_cast<std::ptrdiff_t>(x.size());
  std::vector<double> w(static_cast<std::size_t>(sinc.taps)), edge(w.size()), y;
  y.reserve(positions.size());
  for (const double position : positions) {
    const double p = std::clamp(position, 0.0, static_cast<double>(size)), whole = std::floor(p);
    kernel.weights(p - whole, w.data());
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(whole) + kernel.first();
    const bool inside = start >= 0 && start + sinc.taps <= size;
    for (std::ptrdiff_t k = 0; !inside && k < sinc.taps; ++k)
      edge[k] = start + k >= 0 && start + k < size ? x[start + k] : 0.0;
    y.push_back(dsp::dot(w.data(), inside ? x.data() + start : edge.data(), sinc.taps));
  }
  return y;
}

std::vector<double> samples_at_angles(const std::vector<double>& theta, double first, int per_cycle,
                                      std::size_t count) {
  std::vector<double> at;
  at.reserve(count);
  std::size_t n = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const double angle = first + static_cast<double>(j) / per_cycle;
    while (n + 2 < theta.size() && theta[n + 1] <= angle) ++n;
    at.push_back(static_cast<double>(n) + (angle - theta[n]) / (theta[n + 1] - theta[n]));
  }
  return at;
}

std::vector<double> zero_phase_high_pass(const std::vector<double>& x, double frequency_hz, double rate) {
  return zero_phase(x, dsp::Pass::kHigh, frequency_hz, rate);
}

std::vector<double> zero_phase_low_pass(const std::vector<double>& x, double frequency_hz, double rate) {
  return zero_phase(x, dsp::Pass::kLow, frequency_hz, rate);
}

std::vector<double> decimated(const std::vector<double>& x, int factor) {
  const dsp::InterpolationKernel kernel(2 * kDecimatorReach * factor, 1, 8, 0.9 / factor);
  std::vector<double> w(static_cast<std::size_t>(kernel.taps())),
      y(x.size() / static_cast<std::size_t>(factor));
  kernel.weights(0, w.data());
  const auto size = static_cast<std::ptrdiff_t>(x.size());
  for (std::size_t n = 0; n < y.size(); ++n) {
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(n) * factor + kernel.first();
    for (std::ptrdiff_t k = 0; k < kernel.taps(); ++k)
      if (start + k >= 0 && start + k < size) y[n] += w[k] * x[start + k];
  }
  return y;
}

}  // namespace rigsound::analysis
