#include "rigsound/dsp/interpolation_kernel.hpp"

#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {
namespace {

/// Modified Bessel function of order zero, its power series up to the last bit: 60 terms at most for x <= 20.
double bessel_i0(double x) {
  double sum = 1, term = 1;
  for (int k = 1; k < 60 && sum + term != sum; ++k) term *= (x / (2 * k)) * (x / (2 * k)), sum += term;
  return sum;
}

}  // namespace

InterpolationKernel::InterpolationKernel(int taps, int phases, double beta, double cut)
    : taps_(taps), phases_(phases) {
  rows_.reserve(static_cast<std::size_t>((phases + 1) * taps));
  const double half = taps / 2.0, window_peak = bessel_i0(beta);
  for (int row = 0; row <= phases; ++row) {
    double sum = 0;
    const std::size_t start = rows_.size();
    for (int k = 0; k < taps; ++k) {
      const double t = k + 1 - half - static_cast<double>(row) / phases;
      const double inside = 1 - t * t / (half * half);
      const double window = inside > 0 ? bessel_i0(beta * std::sqrt(inside)) / window_peak : 0.0;
      const double sinc = t == 0 ? 1.0 : sin(kPi * cut * t) / (kPi * cut * t);
      rows_.push_back(sinc * window);
      sum += rows_.back();
    }
    for (std::size_t k = start; k < rows_.size(); ++k) rows_[k] /= sum;
  }
}

void InterpolationKernel::weights(double fraction, double* w) const noexcept {
  const double position = fraction * phases_;
  const double row = std::floor(position);
  const double* a = rows_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(taps_);
  const double* b = a + taps_;
  const Lanes alpha = {position - row, position - row};
  for (int k = 0; k < taps_; k += 8) {
    const Lanes a0 = load(a + k), a1 = load(a + k + 2), a2 = load(a + k + 4), a3 = load(a + k + 6);
    store(w + k, a0 + alpha * (load(b + k) - a0));
    store(w + k + 2, a1 + alpha * (load(b + k + 2) - a1));
    store(w + k + 4, a2 + alpha * (load(b + k + 4) - a2));
    store(w + k + 6, a3 + alpha * (load(b + k + 6) - a3));
  }
}

}  // namespace rigsound::dsp
