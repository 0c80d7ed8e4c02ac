#include "engine/diesel/diesel_measures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "diesel/crank.hpp"
#include "rigsound/dsp/interpolation_kernel.hpp"
#include "rigsound/machine/rpm_tracker.hpp"

namespace rigsound::tests {

using namespace rigsound::diesel;

ResamplingError resampling_error() {
  constexpr int N = 1024;
  constexpr double kRate = 48000;
  const dsp::InterpolationKernel kernel(16, 256, 8);
  std::vector<double> engine_like(N, 0.0), white(N, 0.0);
  const auto phase = [](int k) { return 1.7 * k * k; };
  for (int k = 1; k <= N / 4; ++k)
    for (int n = 0; n < N; ++n) {
      const double c = std::cos(2 * M_PI * (k * n % N) / N + phase(k));
      white[static_cast<std::size_t>(n)] += c;
      engine_like[static_cast<std::size_t>(n)] += c * std::pow(k, -1.5);
    }
  Crank crank;
  AngleSpan span;
  double error[2] = {}, total[2] = {};
  double angle = 0;
  for (int chunk = 0; chunk < 3000; chunk += 15) {
    const double f = (600 + 0.6 * chunk) / 120;
    crank.turn(f, f, kRate);
    crank.span(N, span);
    for (std::size_t n = 0; n < kChunk; ++n) {
      double w[16], got[2] = {}, want[2] = {};
      kernel.weights(span.fraction[n], w);
      for (int k = 0; k < 16; ++k) {
        const auto i = static_cast<std::size_t>((span.base + span.offset[n] + kernel.first() + k + N) % N);
        got[0] += w[k] * white[i], got[1] += w[k] * engine_like[i];
      }
      for (int k = 1; k <= N / 4; ++k) {
        const double c = std::cos(2 * M_PI * k * angle + phase(k));
        want[0] += c, want[1] += c * std::pow(k, -1.5);
      }
      for (int i = 0; i < 2; ++i) error[i] += std::pow(got[i] - want[i], 2), total[i] += want[i] * want[i];
      angle += f / kRate;
    }
  }
  return {10 * std::log10(error[0] / total[0]), 10 * std::log10(error[1] / total[1])};
}

TrackerError tracker_error() {
  RpmTracker tracker;
  const auto truth = [](double t) { return t < 2 ? 600.0 : t < 4 ? 600 + 900 * (t - 2) : 2400.0; };
  double ramp = 0, settled = 0, overshoot = 0;
  int ramps = 0, settles = 0;
  double next = 0.02, sent = 0.02;
  for (double t = 0; t < 8; t += 1e-3) {
    if (t >= next + 0.002) {
      tracker.message(t, std::round(truth(sent) * 8) / 8);
      next += 0.02, sent = next;
    }
    if (t < 1) continue;
    const double cents = 1200 * std::log2(tracker.at(t).rpm / truth(t));
    if (t > 2.2 && t < 4) ramp += cents * cents, ++ramps;
    if (t > 5) settled += cents * cents, ++settles;
    if (t > 4) overshoot = std::max(overshoot, cents);
  }
  return {std::sqrt(settled / settles), std::sqrt(ramp / ramps), overshoot};
}

}  // namespace rigsound::tests
