#include "diesel/order_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {

std::vector<double> order_spectrum(const std::vector<double>& y, int N, int cycles) {
  const int size = N * cycles;  // powers of two both
  const dsp::Fft<double> fft(size);
  std::vector<double> power(static_cast<std::size_t>(size / 2 + 1), 0.0), re(static_cast<std::size_t>(size)),
      im(re.size());
  int segments = 0;
  for (std::size_t at = 0; at + re.size() <= y.size(); at += re.size() / 2, ++segments) {
    for (std::size_t i = 0; i < re.size(); ++i) {
      re[i] = y[at + i] * (0.5 - 0.5 * std::cos(2 * M_PI * static_cast<double>(i) / size));
      im[i] = 0;
    }
    fft.forward(re.data(), im.data());
    for (std::size_t b = 0; b < power.size(); ++b) power[b] += re[b] * re[b] + im[b] * im[b];
  }
  const double scale = 2.0 / (0.375 * static_cast<double>(size) * size * std::max(1, segments));
  for (double& p : power) p *= scale;
  return power;
}

}  // namespace rigsound::analysis
