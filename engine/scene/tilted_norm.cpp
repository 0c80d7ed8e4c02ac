#include "scene/tilted_norm.hpp"

#include <algorithm>

namespace rigsound::scene {

TiltedNorm::TiltedNorm(const drill::ClickSpectrum& clicks) {
  for (int i = 0; i <= kSteps; ++i)
    ln_[static_cast<std::size_t>(i)] = clicks.ln_norm(kLargestTilt * (2.0 * i / kSteps - 1));
}

double TiltedNorm::ln(double tilt) const noexcept {
  const double at = std::clamp((tilt / kLargestTilt + 1) * (kSteps / 2.0), 0.0, static_cast<double>(kSteps));
  const auto step = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kSteps - 1));
  return ln_[step] + (at - static_cast<double>(step)) * (ln_[step + 1] - ln_[step]);
}

}  // namespace rigsound::scene
