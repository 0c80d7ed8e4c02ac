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

void Strikes::render(const Pulse& pulse, Excitation& out) const noexcept {
  const double end = pulse.onset + width_;
  const int first =
      static_cast<int>(std::max(0.0, std::floor(pulse.onset) + (pulse.onset > std::floor(pulse.onset))));
  if (pulse.onset > -1 && first < kChunk) out.slope[first] = pulse.slope;
  for (int n = first; n < kChunk && n < end; ++n)
    out.x[n] += pulse.amplitude / 2 * (1 - dsp::cos(dsp::kTwoPi * (n - pulse.onset) / width_));
}

void Strikes::process(const Impact* impacts, int count, double period, Excitation& out) noexcept {
  for (int i = 0; i < count; ++i) add(impacts[i], period);
  out = {};
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    Pulse pulse = pulses_[static_cast<std::size_t>(i)];
    if (pulse.onset < kChunk) render(pulse, out);
    pulse.onset -= kChunk;
    if (pulse.onset + width_ > 0) pulses_[static_cast<std::size_t>(kept++)] = pulse;
  }
  count_ = kept;
}

}  // namespace rigsound::tool
