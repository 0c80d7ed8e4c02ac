#include "mix/output.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigsound::mix {
namespace {

using Pair = float __attribute__((vector_size(8)));

/// Frames of two channels to the first two of `channels`, or to the only one.
void spread(const Pair* frames, int channels, float* out) noexcept {
  if (channels == 2) {
    std::memcpy(out, frames, kChunk * sizeof *frames);
    return;
  }
  for (int n = 0; n < kChunk; ++n, out += channels) {
    out[0] = frames[n][0];
    if (channels == 1) continue;
    out[1] = frames[n][1];
    std::fill(out + 2, out + channels, 0.0F);
  }
}

}  // namespace

void Output::write(const dsp::Lanes* x, const GainCurve& gain, float* out) noexcept {
  Pair frames[kChunk];
  dsp::Lanes energy{}, most{};
  const auto take = [&](int n, dsp::Lanes y) {
    const dsp::Lanes square = y * y;
    energy += square;
    most = dsp::larger(most, square);
    frames[n] = __builtin_convertvector(y, Pair);
  };
  if (gain.is_one())
    for (int n = 0; n < kChunk; ++n) take(n, x[n]);
  else
    for (int n = 0; n < kChunk; ++n) take(n, gain.at(n) * x[n]);
  energy_ += energy;
  most_ = dsp::larger(most_, most);
  spread(frames, channels_, out);
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
