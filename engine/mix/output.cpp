#include "mix/output.hpp"

#include <algorithm>
#include <cmath>

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
  dsp::Lanes energy{}, most{};
  const auto take = [&](int n, dsp::Lanes y, dsp::Lanes z) {
    const dsp::Lanes square = y * y, next = z * z;
    energy += square;
    energy += next;
    most = dsp::larger(most, dsp::larger(square, next));
    dsp::store_floats(frames + 2 * n, dsp::narrowed(y, z));
  };
  if (gain.is_one())
    for (int n = 0; n < kChunk; n += 2) take(n, x[n], x[n + 1]);
  else
    for (int n = 0; n < kChunk; n += 2) take(n, gain.at(n) * x[n], gain.at(n + 1) * x[n + 1]);
  energy_ += energy;
  most_ = dsp::larger(most_, most);
  if (frames != out) spread(frames, channels_, out);
  // Rounding to single precision may pass the ceiling.
  const double limit = static_cast<double>(ceiling_);
  if (std::max(most[0], most[1]) >= limit * limit)
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
