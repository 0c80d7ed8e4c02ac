#include "mix/output.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigsound::mix {
namespace {

using Pair = float __attribute__((vector_size(8)));

/// One frame to the first two channels, or to the only one.
void store(dsp::Lanes y, int channels, float* frame) noexcept {
  const Pair pair = __builtin_convertvector(y, Pair);
  if (channels == 1)
    frame[0] = pair[0];
  else
    std::memcpy(frame, &pair, sizeof pair);
}

}  // namespace

void Output::write(const dsp::Lanes* x, const GainCurve& gain, float* out) noexcept {
  if (channels_ > 2) write_silence(out);
  dsp::Lanes energy{}, most{};
  const auto write_each = [&](auto frame) {
    for (int n = 0; n < kChunk; ++n) {
      const dsp::Lanes y = frame(n), square = y * y;
      energy += square;
      most = most < square ? square : most;
      store(y, channels_, out + n * channels_);
    }
  };
  if (gain.is_one())
    write_each([x](int n) { return x[n]; });
  else
    write_each([&](int n) { return gain.at(n) * x[n]; });
  energy_ += energy;
  most_ = most_ < most ? most : most_;
  // Rounding to single precision may pass the ceiling.
  const double limit = static_cast<double>(ceiling_);
  if (std::max(most[0], most[1]) >= limit * limit)
    for (int i = 0; i < kChunk * channels_; ++i) out[i] = std::clamp(out[i], -ceiling_, ceiling_);
}

void Output::write_silence(float* out) noexcept { std::fill(out, out + kChunk * channels_, 0.0F); }

LayerLevel Output::take(int samples) noexcept {
  const LayerLevel level{static_cast<float>(std::sqrt(std::max(most_[0], most_[1]))),
                         static_cast<float>(std::sqrt((energy_[0] + energy_[1]) / samples))};
  energy_ = most_ = dsp::Lanes{};
  return level;
}

}  // namespace rigsound::mix
