// Sounds of impacts that are known: noise bursts at a rate, coloured, scattered.
#pragma once

#include <cmath>
#include <vector>

#include "analysis/noise.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {

struct ImpactSound {
  double rate_hz = 40;
  double scatter = 0.03;   ///< standard deviation of the gaps over their mean
  double missing = 0;      ///< share of impacts
  double decay_s = 0.006;  ///< of amplitude by 1/e
  double level = 0.1;
  double tilt = 0;  ///< 0: white ... 1: low frequencies only
};

/// Gaps scatter about an even grid's, one after the other.
inline std::vector<float> impact_sound(const ImpactSound& s, double seconds, unsigned seed) {
  TestNoise noise(seed);
  const auto size = static_cast<long>(seconds * kAnalysisRate);
  Eigen::ArrayXd x = Eigen::ArrayXd::Zero(size);
  const auto length = static_cast<long>(7 * s.decay_s * kAnalysisRate);
  const double fall = std::exp(-1 / (s.decay_s * kAnalysisRate));
  for (double at = 0.01; at < seconds; at += (1 + s.scatter * noise.normal()) / s.rate_hz) {
    if (noise.uniform() < s.missing) continue;
    const long start = std::lround(at * kAnalysisRate);
    double level = s.level, before = 0;
    for (long n = start; n < std::min(size, start + length); ++n, level *= fall) {
      before = s.tilt * before + (1 - s.tilt) * noise.normal();
      x(n) += level * before;
    }
  }
  return samples(x);
}

}  // namespace rigsound::analysis
