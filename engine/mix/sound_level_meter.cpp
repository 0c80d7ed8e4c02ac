#include "rigsound/sound_level_meter.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/ramp.hpp"
#include "rigsound/dsp/weighting.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound {
namespace {

constexpr double kFast_s = 0.125, kSlow_s = 1;
constexpr double kGone = 1e-20;  // a power

}  // namespace

SoundLevelMeter::SoundLevelMeter(double sample_rate, int channels)
    : channels_(channels),
      fast_(dsp::one_pole_remainder(kFast_s, kChunk, sample_rate)),
      slow_(dsp::one_pole_remainder(kSlow_s, kChunk, sample_rate)) {
  const dsp::Weighting weights = dsp::weighting(sample_rate);
  for (int i = 0; i < 2; ++i) c_[i] = dsp::BiquadPair(weights.c[i]);
  a_ = dsp::BiquadPair(weights.a);
}

bool SoundLevelMeter::rests(const float* x) const noexcept {
  return c_[0].rests() && c_[1].rests() && a_.rests() &&
         std::all_of(x, x + kChunk * channels_, [](float s) { return s == 0; });
}

/// A-weighted power of a chunk.
double SoundLevelMeter::chunk(const float* x) noexcept {
  if (rests(x)) return 0;
  dsp::Lanes y[kChunk];
  for (int n = 0; n < kChunk; ++n, x += channels_)
    y[n] = dsp::Lanes{static_cast<double>(x[0]), channels_ > 1 ? static_cast<double>(x[1]) : 0.0};
  for (dsp::BiquadPair& section : c_) section.process(y, kChunk), section.settle();
  double peak = 0;
  for (const dsp::Lanes& frame : y) peak = std::max(peak, std::fabs(dsp::total(frame)));
  level_.c_peak = std::max(level_.c_peak, peak);
  a_.process(y, kChunk), a_.settle();
  dsp::Lanes energy{};
  for (const dsp::Lanes& frame : y) energy += frame * frame;
  return 2 * dsp::total(energy) / kChunk;
}

void SoundLevelMeter::process(const float* x, int frames) noexcept {
  level_.mean = level_.c_peak = 0;
  for (int n = 0; n < frames; n += kChunk) {
    const double power = chunk(x + n * channels_);
    level_.mean += power * kChunk / frames;
    level_.fast = dsp::approached(level_.fast, power, fast_);
    level_.slow = dsp::approached(level_.slow, power, slow_);
    if (level_.fast < kGone) level_.fast = 0;
    if (level_.slow < kGone) level_.slow = 0;
  }
}

}  // namespace rigsound
