#include "diesel/phase_advance.hpp"

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/dsp/fft.hpp"

namespace rigsound::analysis {

std::vector<double> phase_advanced(const std::vector<double>& x, double f_x) {
  std::size_t size = 1;
  while (size < x.size() + static_cast<std::size_t>(kAnalysisRate))
    size *= 2;  // what is early wraps to the end
  std::vector<double> re = x, im(size, 0.0), h(size, 0.0), h_im(size, 0.0);
  re.resize(size, 0.0);
  dsp::Butterworth6 filter(dsp::Pass::kHigh, f_x, kAnalysisRate);
  for (std::size_t n = 0; n < size; ++n) h[n] = filter.process(n == 0 ? 1.0 : 0.0);
  const dsp::Fft<double> fft(static_cast<int>(size));
  fft.forward(re.data(), im.data());
  fft.forward(h.data(), h_im.data());
  for (std::size_t b = 0; b < size; ++b) {
    const double magnitude = std::hypot(h[b], h_im[b]) + 1e-12;
    const double c = h[b] / magnitude, s = -h_im[b] / magnitude, r = re[b];
    re[b] = r * c - im[b] * s, im[b] = r * s + im[b] * c;
  }
  fft.inverse(re.data(), im.data());
  re.resize(x.size());
  for (double& v : re) v /= static_cast<double>(size);
  return re;
}

}  // namespace rigsound::analysis
