#include "diesel/tone_bank.hpp"

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {
namespace {

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

ToneBank::ToneBank(const std::vector<DieselOscillator>& tones, double sample_rate, std::uint64_t seed,
                   std::uint64_t stream)
    : sample_rate_(sample_rate), random_(seed, stream) {
  for (const DieselOscillator& line : tones) tones_.push_back({line, random_.uniform(tones_.size(), 3)});
}

void ToneBank::add(double f, const dsp::Ramp& gain, double* out) noexcept {
  const double slope = (gain.to - gain.from) / kChunk;
  std::uint64_t index = chunk_++ * (tones_.size() + 1);
  for (Tone& tone : tones_) {
    const double hz = tone.line.order_locked ? tone.line.frequency * f : tone.line.frequency;
    const double step = dsp::kTwoPi * hz / sample_rate_;
    if (step < dsp::kPi * 0.92) {
      const double from = tone.line.amplitude * gain.from, rise = tone.line.amplitude * slope;
      turn(tone.phase, step, dsp::Lanes{from + rise, from + 2 * rise}, 2 * rise, out);
    }
    // Brownian phase: variance 2 pi * linewidth a second makes a Lorentzian line of that width.
    const double walk = std::sqrt(dsp::kTwoPi * tone.line.linewidth_hz * kChunk / sample_rate_) / dsp::kTwoPi;
    tone.phase += hz * kChunk / sample_rate_ + walk * random_.white(index++, 0);
    tone.phase -= std::floor(tone.phase);
  }
}

}  // namespace rigsound::diesel
