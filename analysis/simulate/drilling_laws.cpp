#include "simulate/drilling_laws.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLowestRateHz = 38, kHighestRateHz = 42;  // at the normal feed

// Slopes over the feed, 1/bar.
constexpr double kLnRate = -0.0011, kLnNorm = 0.0035, kLnDecay = 0.008, kGapVariation = -0.0004,
                 kNormVariation = -0.0011, kTiltDb = -0.05, kDieselRpm = 2.2;
// Values at the normal feed.
constexpr double kNominalRateHz = 40, kNormalDecay_s = 115, kNormalGapVariation = 0.03,
                 kNormalNormVariation = 0.10, kNormalTiltDb = -1, kNormalRpm = 1900;
// What is left of the variations where the machine is pressed hardest.
constexpr double kLeastGapVariation = 0.006, kLeastNormVariation = 0.03;
// Impacts that do not come: their share at the underfeed point, and the feed over which it falls by e.
constexpr double kUnderfeedMiss = 0.13, kMissFall_bar = 18;
// The string rings where it is not pressed on: half of its most at this feed, over this width.
constexpr double kMostRing = 0.5, kHalfRing_bar = 62, kRingWidth_bar = 10;
// Slopes over the rods beyond the first.
constexpr double kLnRatePerRod = -0.008, kLnNormPerRod = -0.04, kLnDecayPerRod = -0.05, kTiltDbPerRod = -0.2;

/// L2 norm of the mean click with which normal drilling has its level.
double normal_norm() {
  const double squares = 1 + kNormalNormVariation * kNormalNormVariation;
  return DrillingLaws::kNormalRms * std::sqrt(kAnalysisRate / kNominalRateHz / squares);
}

}  // namespace

BiquadCascade drilling_colour(const DrillingPoint& point) {
  BiquadCascade colour = {highpass(80),         one_pole(7000),      peaking(340, 7, 2),
                          peaking(900, 5, 1.5), peaking(2400, 8, 3), peaking(4300, 6, 4)};
  // Each shelf bears two octaves of the slope; together they are straight to 1 dB from 160 Hz to 8 kHz.
  for (const double f : {250.0, 1000.0, 4000.0})
    colour.push_back(high_shelf(f, 2 * point.tilt_db_per_octave));
  return colour;
}

DrillingLaws::DrillingLaws(std::uint64_t seed)
    : rate_hz_(SplitMix(dsp::mix64(seed)).uniform(kLowestRateHz, kHighestRateHz)) {}

DrillingPoint DrillingLaws::at(double feed_bar, int rods) const {
  const double over = feed_bar - kNormal_bar, more = rods - 1;
  DrillingPoint p;
  p.rate_hz = rate_hz_ * std::exp(kLnRate * over + kLnRatePerRod * more);
  p.gap_variation = std::max(kNormalGapVariation + kGapVariation * over, kLeastGapVariation);
  p.miss_share = kUnderfeedMiss * std::min(1.0, std::exp((kUnderfeed_bar - feed_bar) / kMissFall_bar));
  p.norm = normal_norm() * std::exp(kLnNorm * over + kLnNormPerRod * more);
  p.norm_variation = std::max(kNormalNormVariation + kNormVariation * over, kLeastNormVariation);
  p.decay = kNormalDecay_s / kAnalysisRate * std::exp(kLnDecay * over + kLnDecayPerRod * more);
  p.tilt_db_per_octave = kNormalTiltDb + kTiltDb * over + kTiltDbPerRod * more;
  p.ring_share = kMostRing / (1 + std::exp((feed_bar - kHalfRing_bar) / kRingWidth_bar));
  p.diesel_rpm = kNormalRpm + kDieselRpm * over;
  return p;
}

FeedLaws DrillingLaws::slopes() {
  FeedLaws laws;
  laws.ln_gap = -kLnRate, laws.ln_level = kLnNorm, laws.ln_decay = kLnDecay;
  laws.gap_variation = kGapVariation, laws.amplitude_variation = kNormVariation;
  laws.tilt_db_per_octave = kTiltDb;
  return laws;
}

}  // namespace rigsound::analysis
