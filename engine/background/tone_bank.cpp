#include "background/tone_bank.hpp"

#include "dsp/lanes.hpp"
#include "rigsound/limits.hpp"

namespace rigsound::background {
namespace {

constexpr double kUnit = 3.46410161513775;  // sqrt 12: a uniform number of unit variance

/// Adds kChunk samples of a cosine, two side by side: each lane turns by two steps at a time.
void turn(double phase, double step, dsp::Lanes gain, double rise, double* out) noexcept {
  const double c0 = dsp::cos(dsp::kTwoPi * phase), s0 = dsp::sin(dsp::kTwoPi * phase);
  const double dc = dsp::cos(step), ds = dsp::sin(step);
  dsp::Lanes c = {c0, c0 * dc - s0 * ds}, s = {s0, c0 * ds + s0 * dc};
  const double c2 = dc * dc - ds * ds, s2 = 2 * dc * ds;
  for (int n = 0; n < kChunk; n += 2) {
    dsp::store(out + n, dsp::load(out + n) + gain * c);
    gain += rise;
    const dsp::Lanes turned = c * c2 - s * s2;
    s = c * s2 + s * c2;
    c = turned;
  }
}

}  // namespace

ToneBank::ToneBank(const std::vector<BackgroundOscillator>& tones, double sample_rate, std::uint64_t seed,
                   std::uint64_t stream)
    : sample_rate_(sample_rate), random_(seed, stream) {
  for (const BackgroundOscillator& line : tones) tones_.push_back({line, random_.uniform(tones_.size(), 3)});
}

void ToneBank::add(double f, double gain_from, double gain_to, double* out) noexcept {
  const double slope = (gain_to - gain_from) / kChunk;
  std::uint64_t index = chunk_++ * (tones_.size() + 1);
  for (Tone& tone : tones_) {
    const double hz = tone.line.order_locked ? tone.line.frequency * f : tone.line.frequency;
    const double step = dsp::kTwoPi * hz / sample_rate_;
    if (step < dsp::kPi * 0.92) {
      const double from = tone.line.amplitude * gain_from, rise = tone.line.amplitude * slope;
      turn(tone.phase, step, dsp::Lanes{from + rise, from + 2 * rise}, 2 * rise, out);
    }
    // Brownian phase: variance 2 pi * linewidth a second makes a Lorentzian line of that width.
    const double walk = std::sqrt(dsp::kTwoPi * tone.line.linewidth_hz * kChunk / sample_rate_) / dsp::kTwoPi;
    tone.phase += hz * kChunk / sample_rate_ + walk * kUnit * (random_.uniform(index++, 0) - 0.5);
    tone.phase -= std::floor(tone.phase);
  }
}

}  // namespace rigsound::background
