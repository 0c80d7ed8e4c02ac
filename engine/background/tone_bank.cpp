#include "background/tone_bank.hpp"

#include "rigsound/limits.hpp"

namespace rigsound::background {

ToneBank::ToneBank(const std::vector<BackgroundOscillator>& tones, double sample_rate, std::uint64_t seed,
                   std::uint64_t stream)
    : sample_rate_(sample_rate), random_(seed, stream) {
  for (const BackgroundOscillator& line : tones) tones_.push_back({line, random_.uniform(tones_.size(), 3)});
}

void ToneBank::add(double f, double gain, double* out) noexcept {
  std::uint64_t index = chunk_++ * (tones_.size() + 1);
  for (Tone& tone : tones_) {
    const double hz = tone.line.order_locked ? tone.line.frequency * f : tone.line.frequency;
    const double step = dsp::kTwoPi * hz / sample_rate_;
    if (step < dsp::kPi * 0.92) {
      double c = dsp::cos(dsp::kTwoPi * tone.phase), s = dsp::sin(dsp::kTwoPi * tone.phase);
      const double dc = dsp::cos(step), ds = dsp::sin(step), a = gain * tone.line.amplitude;
      for (int n = 0; n < kChunk; ++n) {
        out[n] += a * c;
        const double turned = c * dc - s * ds;
        s = c * ds + s * dc;
        c = turned;
      }
    }
    // Brownian phase: variance 2 pi * linewidth a second makes a Lorentzian line of that width.
    const double walk = std::sqrt(dsp::kTwoPi * tone.line.linewidth_hz * kChunk / sample_rate_) / dsp::kTwoPi;
    tone.phase += hz * kChunk / sample_rate_ + walk * random_.normal(index++, 0);
    tone.phase -= std::floor(tone.phase);
  }
}

}  // namespace rigsound::background
