#include "mix/limiter.hpp"

#include <algorithm>

#include "rigsound/dsp/ramp.hpp"

namespace rigsound::mix {
namespace {

constexpr double kRelease_s = 0.12;
constexpr double kAttackSlope = 1.0 / kChunk;  // gain falls at most this much a sample ahead of a peak
constexpr double kAbsurd = 1e9;                // a layer that gets here has failed; its sample is dropped

}  // namespace

Limiter::Limiter(double ceiling, int channels, double sample_rate) noexcept
    : ceiling_(ceiling), release_(dsp::one_pole_remainder(kRelease_s, 1, sample_rate)), channels_(channels) {}

void Limiter::process(double (*x)[kChunk]) noexcept {
  double allowed[kChunk];
  for (int n = 0; n < kChunk; ++n) {
    double peak = 0;
    for (int c = 0; c < channels_; ++c) {
      double& sample = x[c][n];
      if (!(std::fabs(sample) < kAbsurd)) sample = 0;
      peak = std::max(peak, std::fabs(sample));
    }
    allowed[n] = peak > ceiling_ ? ceiling_ / peak : 1.0;
  }
  for (int n = kChunk - 2; n >= 0; --n) allowed[n] = std::min(allowed[n], allowed[n + 1] + kAttackSlope);
  lowest_ = 1;
  for (int n = 0; n < kChunk; ++n) {
    gain_ = std::min(allowed[n], 1 - (1 - gain_) * release_);
    lowest_ = std::min(lowest_, gain_);
    for (int c = 0; c < channels_; ++c) x[c][n] *= gain_;
  }
}

}  // namespace rigsound::mix
