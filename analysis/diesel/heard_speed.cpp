#include "diesel/heard_speed.hpp"

#include <algorithm>
#include <cmath>

#include "diesel/angle_domain.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/diesel_model.hpp"
#include "spectrum/window_power.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kDecimation = 16, kLongestWindow = 16384;  // 3 kHz, 5.5 s
constexpr double kLowestOrderHeard_hz = 12, kHighestOrderHeard_hz = 300;
constexpr double kFloorWidth_hz = 8, kFloorPart = 0.4;
constexpr double kSpeedWander = 0.002, kSpeedStep = 0.0008;  // relative
constexpr double kOrderCost = 0.8, kMostOfOrder = 4;         // nepers of power
constexpr double kGivenWithin = 0.03, kApart = 0.02;         // relative: nearer is the same speed
constexpr double kTwoThirdsSure = 4;  // nepers over the next for a confidence of 1 - 1/e

/// How far every bin stands over the floor around it, nepers of power.
struct Prominence {
  std::vector<double> of;
  double bin_hz = 0;
};

std::vector<double> mean_power(const std::vector<double>& x, double& bin_hz) {
  const std::vector<double> slow = decimated(x, kDecimation);
  const std::vector<float> y(slow.begin(), slow.end());
  int length = kLongestWindow;
  while (length > 64 && static_cast<std::size_t>(2 * length) > y.size()) length /= 2;
  WindowPower power(length);
  for (std::size_t at = 0; at + static_cast<std::size_t>(length) <= y.size();
       at += static_cast<std::size_t>(length / 4))
    power.add(y.data() + at, 1);
  bin_hz = kAnalysisRate / kDecimation / length;
  return power.power();
}

Prominence prominence_of(const std::vector<double>& x) {
  Prominence p;
  const std::vector<double> power = mean_power(x, p.bin_hz);
  const auto reach = static_cast<std::ptrdiff_t>(std::lround(kFloorWidth_hz / p.bin_hz / 2));
  const auto size = static_cast<std::ptrdiff_t>(
      std::min(power.size(), static_cast<std::size_t>(1.1 * kHighestOrderHeard_hz / p.bin_hz)));
  for (std::ptrdiff_t b = 0; b < size; ++b) {
    const std::vector<double> around(power.begin() + std::max<std::ptrdiff_t>(0, b - reach),
                                     power.begin() + std::min(size, b + reach + 1));
    p.of.push_back(
        std::min(std::log((power[b] + 1e-30) / (quantile(around, kFloorPart) + 1e-30)), kMostOfOrder));
  }
  return p;
}

/// What speaks for a cycle of that many hertz.
double evidence(const Prominence& p, double f0) {
  double sum = 0;
  for (int k = std::max(1, static_cast<int>(std::ceil(kLowestOrderHeard_hz / f0)));
       k * f0 <= kHighestOrderHeard_hz; ++k) {
    const auto at = std::lround(k * f0 / p.bin_hz);
    const auto reach = std::max(1L, std::lround(kSpeedWander * k * f0 / p.bin_hz));
    const auto end = std::min<std::ptrdiff_t>(at + reach + 1, static_cast<std::ptrdiff_t>(p.of.size()));
    if (at - reach >= end) break;
    sum += *std::max_element(p.of.begin() + at - reach, p.of.begin() + end) - kOrderCost;
  }
  return sum;
}

struct Candidate {
  double rpm, evidence;
};

bool less_likely(const Candidate& a, const Candidate& b) { return a.evidence < b.evidence; }

double confidence_of(double margin) { return margin > 0 ? 1 - std::exp(-margin / kTwoThirdsSure) : 0; }

/// The best of those within `apart` of a speed.
double evidence_near(const std::vector<Candidate>& candidates, double rpm, double apart) {
  double best = 0;
  for (const Candidate& c : candidates)
    if (std::fabs(c.rpm / rpm - 1) <= apart) best = std::max(best, c.evidence);
  return best;
}

}  // namespace

HeardSpeed heard_speed(const std::vector<double>& x, double given_rpm) {
  const Prominence p = prominence_of(x);
  std::vector<Candidate> candidates;
  for (double rpm = kSlowestDiesel_rpm; rpm <= kFastestDiesel_rpm; rpm *= 1 + kSpeedStep)
    candidates.push_back({rpm, evidence(p, cycles_per_second(rpm))});
  const Candidate best = *std::max_element(candidates.begin(), candidates.end(), less_likely);
  HeardSpeed heard;
  heard.rpm = best.rpm;
  if (given_rpm > 0)
    heard.over_given = confidence_of(best.evidence - evidence_near(candidates, given_rpm, kGivenWithin));
  const auto others = std::remove_if(candidates.begin(), candidates.end(), [&](const Candidate& c) {
    return std::fabs(std::log(c.rpm / best.rpm)) < kApart;
  });
  const Candidate next = *std::max_element(candidates.begin(), others, less_likely);
  heard.confidence = confidence_of(best.evidence - std::max(0.0, next.evidence));
  heard.next_rpm = next.rpm;
  return heard;
}

}  // namespace rigsound::analysis
