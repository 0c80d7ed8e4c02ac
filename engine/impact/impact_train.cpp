#include "impact/impact_train.hpp"

#include <algorithm>

namespace rigsound::impact {
namespace {

enum Field : std::uint64_t { kGapNormal = 0, kAmplitudeNormal = 2, kMissOrDouble = 4 };

// Two blows of one piston are never closer than this share of the period.
constexpr double kShortestGap = 0.1;

/// exp(s z - s^2/2) with s^2 = ln(1 + cv^2): lognormal of mean 1 and coefficient of variation cv.
double lognormal(double cv, double z) noexcept {
  const double s2 = dsp::log(1 + cv * cv);
  return dsp::exp(std::sqrt(s2) * z - 0.5 * s2);
}

double autoregress(double z, double r, double innovation) noexcept {
  return r * z + std::sqrt(1 - r * r) * innovation;
}

}  // namespace

Statistics statistics_of(const ClickBank& bank, double sample_rate, double rate_hz,
                         const DrillControls& controls) noexcept {
  Statistics s;
  s.mean_gap_samples = bank.mean_gap_samples;
  if (rate_hz > 0) s.mean_gap_samples = sample_rate / rate_hz;
  if (controls.mean_frequency_hz > 0)
    s.mean_gap_samples = sample_rate / static_cast<double>(controls.mean_frequency_hz);
  s.gap_variation =
      bank.gap_deviation_samples / bank.mean_gap_samples * static_cast<double>(controls.deviation_time);
  s.amplitude_variation =
      bank.amplitude_deviation / bank.mean_amplitude * static_cast<double>(controls.deviation_amplitude);
  s.gap_correlation = bank.gap_correlation;
  s.amplitude_correlation = bank.amplitude_correlation;
  s.miss_share = bank.miss_share;
  s.double_share = bank.double_share;
  return s;
}

Statistics blend(const Statistics& a, const Statistics& b, double share) noexcept {
  if (share <= 0) return a;
  if (share >= 1) return b;
  const auto mix = [share](double x, double y) { return x + (y - x) * share; };
  Statistics s;
  s.mean_gap_samples = dsp::exp(mix(dsp::log(a.mean_gap_samples), dsp::log(b.mean_gap_samples)));
  s.gap_variation = mix(a.gap_variation, b.gap_variation);
  s.gap_correlation = mix(a.gap_correlation, b.gap_correlation);
  s.miss_share = mix(a.miss_share, b.miss_share);
  s.double_share = mix(a.double_share, b.double_share);
  s.amplitude_variation = mix(a.amplitude_variation, b.amplitude_variation);
  s.amplitude_correlation = mix(a.amplitude_correlation, b.amplitude_correlation);
  return s;
}

ImpactTrain::ImpactTrain(std::uint64_t seed, int boom) noexcept
    : random_(seed, 1, static_cast<std::uint64_t>(boom)) {}

/// A missed strike takes the schedule's next place, a double strike stands between two: neither moves the
/// schedule.
double ImpactTrain::draw_gap(const Statistics& s) noexcept {
  if (after_double_ > 0) {
    const double rest = after_double_;
    after_double_ = 0;
    return rest;
  }
  z_gap_ = autoregress(z_gap_, s.gap_correlation, random_.normal(index_, kGapNormal));
  const double gap = std::max(lognormal(s.gap_variation, z_gap_), kShortestGap);
  const double u = random_.uniform(index_, kMissOrDouble);
  if (u < s.miss_share) return kMissGap * gap;
  if (u >= s.miss_share + s.double_share) return gap;
  after_double_ = (1 - kDoubleGap) * gap;
  return kDoubleGap * gap;
}

double ImpactTrain::draw_amplitude(const Statistics& s) noexcept {
  z_amplitude_ = autoregress(z_amplitude_, s.amplitude_correlation, random_.normal(index_, kAmplitudeNormal));
  return lognormal(s.amplitude_variation, z_amplitude_);
}

void ImpactTrain::process(const Statistics& s) noexcept {
  count_ = 0;
  if (s.snap > 0) impacts_[count_++] = {0, s.snap, index_++};
  if (!(s.mean_gap_samples >= 1)) {
    waited_ = gap_ = 0;
    return;
  }
  // Time is counted in mean gaps, so a change of rate acts at once, also on the gap that is running.
  const double chunk = kChunk / s.mean_gap_samples;
  while (gap_ - waited_ < chunk && count_ < kMaxImpacts) {
    const double onset = std::max(0.0, gap_ - waited_) * s.mean_gap_samples;
    if (!(onset < kChunk)) break;
    impacts_[count_++] = {onset, draw_amplitude(s), index_};
    waited_ -= gap_;
    gap_ = draw_gap(s);
    ++index_;
  }
  waited_ += chunk;
}

}  // namespace rigsound::impact
