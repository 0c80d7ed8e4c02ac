#include "mix/mixer.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::mix {
namespace {

struct Stereo {
  double left, right;
};

/// Equal-power pan law: -3 dB each in the middle.
Stereo pan_law(double pan) {
  const double angle = (pan + 1) * dsp::kPi / 4;
  return {dsp::cos(angle), dsp::sin(angle)};
}

void set_gains(std::array<double, kMaxChannels>& gains, int channels, double gain, double pan) {
  gains.fill(0);
  if (channels == 1) {
    gains[0] = gain;
    return;
  }
  const Stereo place = pan_law(pan);
  gains[0] = gain * place.left;
  gains[1] = gain * place.right;
}

}  // namespace

Mixer::Mixer(const EngineOptions& options)
    : booms_(static_cast<int>(options.booms.size())),
      channels_(options.channels),
      ceiling_(static_cast<float>(dsp::gain_of_db(options.mix.ceiling_dbfs))),
      bands_(static_cast<int>(options.mix.equaliser.size())),
      limiter_(dsp::gain_of_db(options.mix.ceiling_dbfs), options.channels, options.sample_rate) {
  for (int b = 0; b < booms_; ++b) {
    const BoomOptions& boom = options.booms[static_cast<std::size_t>(b)];
    BoomGains& gains = boom_[static_cast<std::size_t>(b)];
    set_gains(gains.drill, channels_, dsp::gain_of_db(options.mix.drill_db + boom.gain_db), boom.pan);
    set_gains(gains.tool, channels_, dsp::gain_of_db(options.mix.tool_db + boom.gain_db), boom.pan);
  }
  set_gains(diesel_, channels_, dsp::gain_of_db(options.mix.diesel_db), 0);
  for (int c = 0; c < channels_; ++c)
    for (const EqualiserBand& band : options.mix.equaliser)
      equaliser_.emplace_back(dsp::peaking(band.frequency_hz, band.gain_db, band.q, options.sample_rate));
}

void Mixer::place(const Buses& buses, double (*x)[kChunk]) const noexcept {
  const auto add = [](const Bus& bus, double gain, double* channel) {
    if (!bus.sounds) return;
    for (int n = 0; n < kChunk; ++n) channel[n] += gain * bus.x[n];
  };
  for (int c = 0; c < channels_; ++c) {
    std::fill(x[c], x[c] + kChunk, 0.0);
    add(buses.diesel, diesel_[static_cast<std::size_t>(c)], x[c]);
    for (int b = 0; b < booms_; ++b) {
      add(buses.drill[b], boom_[static_cast<std::size_t>(b)].drill[static_cast<std::size_t>(c)], x[c]);
      add(buses.tool[b], boom_[static_cast<std::size_t>(b)].tool[static_cast<std::size_t>(c)], x[c]);
    }
  }
}

void Mixer::process(const Buses& buses, const dsp::Ramp& gain, float* out) noexcept {
  double x[kMaxChannels][kChunk];
  place(buses, x);
  for (int c = 0; c < channels_; ++c) {
    dsp::scale(gain, x[c], kChunk);
    for (int e = 0; e < bands_; ++e) {
      dsp::Biquad& band = equaliser_[static_cast<std::size_t>(c * bands_ + e)];
      for (int n = 0; n < kChunk; ++n) x[c][n] = band.process(x[c][n]);
      band.settle();
    }
  }
  limiter_.process(x);
  for (int n = 0; n < kChunk; ++n)
    for (int c = 0; c < channels_; ++c)
      *out++ = std::clamp(static_cast<float>(x[c][n]), -ceiling_, ceiling_);  // rounding to float may pass it
}

}  // namespace rigsound::mix
