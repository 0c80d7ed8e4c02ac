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
  s.T_0 = bank.T_0;
  if (rate_hz > 0) s.T_0 = sample_rate / rate_hz;
  if (controls.mean_frequency_hz > 0) s.T_0 = sample_rate / static_cast<double>(controls.mean_frequency_hz);
  s.cv_T = bank.sigma_T / bank.T_0 * static_cast<double>(controls.deviation_time);
  s.cv_B = bank.sigma_B / bank.B * static_cast<double>(controls.deviation_amplitude);
  s.r_T = bank.r_T;
  s.r_B = bank.r_B;
  s.p_miss = bank.p_miss;
  s.p_double = bank.p_double;
  return s;
}

Statistics blend(const Statistics& a, const Statistics& b, double share) noexcept {
  if (share <= 0) return a;
  if (share >= 1) return b;
  const auto mix = [share](double x, double y) { return x + (y - x) * share; };
  Statistics s;
  s.T_0 = dsp::exp(mix(dsp::log(a.T_0), dsp::log(b.T_0)));
  s.cv_T = mix(a.cv_T, b.cv_T);
  s.r_T = mix(a.r_T, b.r_T);
  s.p_miss = mix(a.p_miss, b.p_miss);
  s.p_double = mix(a.p_double, b.p_double);
  s.cv_B = mix(a.cv_B, b.cv_B);
  s.r_B = mix(a.r_B, b.r_B);
  return s;
}

ImpactTrain::ImpactTrain(std::uint64_t seed, int boom) noexcept
    : random_(seed, 1, static_cast<std::uint64_t>(boom)) {}

double ImpactTrain::draw_gap(const Statistics& s) noexcept {
  z_gap_ = autoregress(z_gap_, s.r_T, random_.normal(index_, kGapNormal));
  double gap = lognormal(s.cv_T, z_gap_);
  const double u = random_.uniform(index_, kMissOrDouble);
  if (u < s.p_miss)
    gap *= kMissGap;
  else if (u < s.p_miss + s.p_double)
    gap *= kDoubleGap;
  return std::max(gap, kShortestGap);
}

double ImpactTrain::draw_amplitude(const Statistics& s) noexcept {
  z_amplitude_ = autoregress(z_amplitude_, s.r_B, random_.normal(index_, kAmplitudeNormal));
  return lognormal(s.cv_B, z_amplitude_);
}

void ImpactTrain::process(const Statistics& s) noexcept {
  count_ = 0;
  if (!(s.T_0 >= 1)) {
    waited_ = gap_ = 0;
    return;
  }
  // Time is counted in mean gaps, so a change of rate acts at once, also on the gap that is running.
  const double chunk = kChunk / s.T_0;
  while (gap_ - waited_ < chunk && count_ < kMaxImpacts) {
    const double onset = std::max(0.0, gap_ - waited_) * s.T_0;
    if (!(onset < kChunk)) break;
    impacts_[static_cast<std::size_t>(count_++)] = {onset, draw_amplitude(s), index_};
    waited_ -= gap_;
    gap_ = draw_gap(s);
    ++index_;
  }
  waited_ += chunk;
}

}  // namespace rigsound::impact
