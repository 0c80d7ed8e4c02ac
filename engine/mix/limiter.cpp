#include "mix/limiter.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/ramp.hpp"

namespace rigsound::mix {
namespace {

constexpr double kRelease_s = 0.12;
constexpr double kAttackSlope = 1.0 / kChunk;  // gain falls at most this much a sample ahead of a peak

}  // namespace

Limiter::Limiter(double ceiling, double sample_rate) noexcept
    : ceiling_(ceiling), release_(dsp::one_pole_remainder(kRelease_s, 1, sample_rate)) {}

void Limiter::process(dsp::Lanes* x) noexcept {
  double allowed[kChunk], lowest = 1;
  for (int n = 0; n < kChunk; ++n) {
    const double peak = std::max(std::fabs(x[n][0]), std::fabs(x[n][1]));
    allowed[n] = peak > ceiling_ ? ceiling_ / peak : 1.0;
    lowest = std::min(lowest, allowed[n]);
  }
  lowest_ = 1;
  if (lowest == 1 && gain_ == 1) return;
  for (int n = kChunk - 2; n >= 0; --n) allowed[n] = std::min(allowed[n], allowed[n + 1] + kAttackSlope);
  limit(allowed, x);
}

void Limiter::limit(const double* allowed, dsp::Lanes* x) noexcept {
  for (int n = 0; n < kChunk; ++n) {
    gain_ = std::min(allowed[n], 1 - (1 - gain_) * release_);
    lowest_ = std::min(lowest_, gain_);
    x[n] *= gain_;
  }
}

}  // namespace rigsound::mix
