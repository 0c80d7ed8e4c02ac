#include "tool/strikes.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::tool {
namespace {

constexpr std::uint64_t kLayer = 0x7001;  // of the random numbers

/// What is drawn anew for one blow: three fields for the blow itself, three for each bounce.
enum Field : std::uint64_t { kAmplitude, kSlope, kFirstBounce };
enum BounceField : std::uint64_t { kGap, kRatio, kBounceSlope, kFieldsPerBounce };

double spread(double share, double uniform) noexcept { return 1 + share * (2 * uniform - 1); }

}  // namespace

Strikes::Strikes(const Strike& strike, double sample_rate, std::uint64_t seed, int boom) noexcept
    : strike_(strike),
      width_(strike.width_s * sample_rate),
      step_(dsp::kTwoPi / width_),
      twice_cos_step_(2 * dsp::cos(step_)),
      random_(seed, kLayer, static_cast<std::uint64_t>(boom)) {}

void Strikes::push(const Pulse& pulse) noexcept {
  if (count_ < kMaxPulses) pulses_[static_cast<std::size_t>(count_++)] = pulse;
}

void Strikes::add(const Impact& impact, double period) noexcept {
  const auto u = [&](std::uint64_t field) { return random_.uniform(impact.index, field); };
  Pulse pulse{impact.onset, impact.amplitude * spread(strike_.amplitude_variation, u(kAmplitude)),
              spread(strike_.slope_variation, u(kSlope))};
  push(pulse);
  for (int i = 0; i < strike_.bounces; ++i) {
    const std::uint64_t field = kFirstBounce + static_cast<std::uint64_t>(i) * kFieldsPerBounce;
    pulse.onset += period * (strike_.gap_min + (strike_.gap_max - strike_.gap_min) * u(field + kGap));
    pulse.amplitude *= strike_.ratio_min + (strike_.ratio_max - strike_.ratio_min) * u(field + kRatio);
    pulse.slope = spread(strike_.slope_variation, u(field + kBounceSlope));
    push(pulse);
  }
}

/// Keeps the touches in order; of two at the same sample the later pulse's counts.
void Strikes::touch(int at, double slope) noexcept {
  int i = touch_count_;
  while (i > 0 && touches_[static_cast<std::size_t>(i - 1)].at > at) --i;
  if (i > 0 && touches_[static_cast<std::size_t>(i - 1)].at == at) {
    touches_[static_cast<std::size_t>(i - 1)].slope = slope;
    return;
  }
  for (int j = touch_count_++; j > i; --j)
    touches_[static_cast<std::size_t>(j)] = touches_[static_cast<std::size_t>(j - 1)];
  touches_[static_cast<std::size_t>(i)] = {at, slope};
}

void Strikes::render(const Pulse& pulse, double* x) noexcept {
  const double down = std::floor(pulse.onset), up = down < pulse.onset ? down + 1 : down;
  const int first = static_cast<int>(std::max(0.0, up));
  if (pulse.onset > -1 && first < kChunk) touch(first, pulse.slope);
  const int end = static_cast<int>(std::min<double>(kChunk, std::ceil(pulse.onset + width_)));
  if (first >= end) return;
  // cos(a + b) = 2 cos(a) cos(b) - cos(a - b), from one sample to the next.
  double now = dsp::cos(step_ * (first - pulse.onset)), before = dsp::cos(step_ * (first - 1 - pulse.onset));
  for (int n = first; n < end; ++n) {
    x[n] += pulse.amplitude / 2 * (1 - now);
    const double next = twice_cos_step_ * now - before;
    before = now, now = next;
  }
}

bool Strikes::process(const Impacts& impacts, double period, double* x) noexcept {
  for (const Impact& impact : impacts) add(impact, period);
  std::fill(x, x + kChunk, 0.0);
  touch_count_ = 0;
  bool struck = false;
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    Pulse pulse = pulses_[static_cast<std::size_t>(i)];
    if (pulse.onset < kChunk) render(pulse, x), struck = true;
    pulse.onset -= kChunk;
    if (pulse.onset + width_ > 0) pulses_[static_cast<std::size_t>(kept++)] = pulse;
  }
  count_ = kept;
  return struck;
}

}  // namespace rigsound::tool
