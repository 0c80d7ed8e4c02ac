#include "spectrum/window_power.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {

int short_window(int rate) {
  constexpr double kWanted_s = 1024 / 48000.0;
  int length = 256;
  while (length * 1.4 < kWanted_s * rate) length *= 2;
  return length;
}

WindowPower::WindowPower(int length) : fft_(length), re_(length), im_(length), power_(length / 2) {
  for (int n = 0; n < length; ++n)
    window_.push_back(static_cast<float>(0.5 - 0.5 * std::cos(dsp::kTwoPi * (n + 0.5) / length)));
}

void WindowPower::clear() { std::fill(power_.begin(), power_.end(), 0.0); }

void WindowPower::add(const float* x, double share) {
  const double full_scale = length() / 4.0;  // what a sine of amplitude 1 leaves in its bin
  for (std::size_t n = 0; n < window_.size(); ++n) re_[n] = window_[n] * x[n];
  std::fill(im_.begin(), im_.end(), 0.0F);
  fft_.forward(re_.data(), im_.data());
  for (std::size_t k = 0; k < power_.size(); ++k) {
    const double re = static_cast<double>(re_[k]), im = static_cast<double>(im_[k]);
    power_[k] += share * (re * re + im * im) / (full_scale * full_scale);
  }
}

double WindowPower::between(double from, double to) const {
  const auto first = static_cast<std::size_t>(std::ceil(from)), end = static_cast<std::size_t>(std::ceil(to));
  if (end > first) {
    double sum = 0;
    for (std::size_t k = first; k < std::min(end, power_.size()); ++k) sum += power_[k];
    return sum / static_cast<double>(end - first);
  }
  const double middle = 0.5 * (from + to);
  const auto below = std::min(static_cast<std::size_t>(middle), power_.size() - 2);
  const double share = middle - static_cast<double>(below);
  return std::pow(power_[below] + 1e-20, 1 - share) * std::pow(power_[below + 1] + 1e-20, share);
}

}  // namespace rigsound::analysis
