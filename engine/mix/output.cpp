#include "mix/output.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/passes.hpp"

namespace rigsound::mix {
namespace {

/// Frames of two channels to the first two of `channels`, or to the only one.
void spread(const float* frames, int channels, float* out) noexcept {
  for (int n = 0; n < kChunk; ++n, out += channels) {
    out[0] = frames[2 * n];
    if (channels == 1) continue;
    out[1] = frames[2 * n + 1];
    std::fill(out + 2, out + channels, 0.0F);
  }
}

}  // namespace

void Output::write(const dsp::Lanes* x, const GainCurve& gain, float* out) noexcept {
  float buffer[2 * kChunk];
  float* const frames = channels_ == 2 ? out : buffer;
  dsp::Lanes scaled[kChunk];
  if (!gain.is_one()) {
    for (int n = 0; n < kChunk; ++n) scaled[n] = gain.at(n) * x[n];
    x = scaled;
  }
  const auto squares =
      dsp::with_widest<dsp::Passes>([&](auto passes) { return passes.narrow(x, kChunk, frames); });
  energy_ += squares.sum;
  most_ = dsp::larger(most_, squares.most);
  if (frames != out) spread(frames, channels_, out);
  // Rounding to single precision may pass the ceiling.
  const double limit = static_cast<double>(ceiling_);
  if (std::max(squares.most[0], squares.most[1]) >= limit * limit)
    for (int i = 0; i < kChunk * channels_; ++i) out[i] = std::clamp(out[i], -ceiling_, ceiling_);
}

void Output::write_silence(float* out) noexcept { std::fill(out, out + kChunk * channels_, 0.0F); }

LayerLevel Output::take(int samples) noexcept {
  const LayerLevel level{std::min(ceiling_, static_cast<float>(std::sqrt(std::max(most_[0], most_[1])))),
                         static_cast<float>(std::sqrt((energy_[0] + energy_[1]) / samples))};
  energy_ = most_ = dsp::Lanes{};
  return level;
}

}  // namespace rigsound::mix
