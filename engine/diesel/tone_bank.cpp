#include "diesel/tone_bank.hpp"

#include <array>

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {
namespace {

/// Adds kChunk samples of a cosine, four side by side: each lane turns by four steps at a time. `gain`: of
/// the first four, growing by `rise` from each four to the next.
void turn(double phase, double step, dsp::FloatLanes gain, float rise, float* out) noexcept {
  const auto [s0, c0] = dsp::sin_cos(dsp::kTwoPi * phase);
  const auto [s1, c1] = dsp::sin_cos(step);
  const double c2 = c1 * c1 - s1 * s1, s2 = 2 * c1 * s1;
  const auto four = [](double a, double b, double c, double d) {
    return dsp::FloatLanes{static_cast<float>(a), static_cast<float>(b), static_cast<float>(c),
                           static_cast<float>(d)};
  };
  const double c01 = c0 * c1 - s0 * s1, s01 = c0 * s1 + s0 * c1;
  dsp::FloatLanes c = four(c0, c01, c0 * c2 - s0 * s2, c01 * c2 - s01 * s2),
                  s = four(s0, s01, c0 * s2 + s0 * c2, c01 * s2 + s01 * c2);
  const auto c4 = static_cast<float>(c2 * c2 - s2 * s2), s4 = static_cast<float>(2 * c2 * s2);
  for (int n = 0; n < kChunk; n += 4) {
    dsp::store_floats(out + n, dsp::load_floats(out + n) + gain * c);
    gain += rise;
    const dsp::FloatLanes turned = c * c4 - s * s4;
    s = c * s4 + s * c4;
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
  std::array<float, kChunk> sum{};
  for (Tone& tone : tones_) {
    const double hz = tone.line.order_locked ? tone.line.frequency * f : tone.line.frequency;
    const double step = dsp::kTwoPi * hz / sample_rate_;
    if (step < dsp::kPi * 0.92) {
      const auto from = static_cast<float>(tone.line.amplitude * gain.from),
                 rise = static_cast<float>(tone.line.amplitude * slope);
      turn(tone.phase, step, from + rise * dsp::FloatLanes{1, 2, 3, 4}, 4 * rise, sum.data());
    }
    // Brownian phase: variance 2 pi * linewidth a second makes a Lorentzian line of that width.
    const double walk = std::sqrt(dsp::kTwoPi * tone.line.linewidth_hz * kChunk / sample_rate_) / dsp::kTwoPi;
    tone.phase += hz * kChunk / sample_rate_ + walk * random_.white(index++, 0);
    tone.phase -= std::floor(tone.phase);
  }
  for (int n = 0; n < kChunk; n += 2) dsp::store(out + n, dsp::load(out + n) + dsp::load(sum.data() + n));
}

}  // namespace rigsound::diesel
