#include "simulate/click_process.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

std::vector<int> draw_onsets(const ClickProcess& process, double seconds, SplitMix& stream) {
  const auto count = static_cast<std::size_t>(seconds * process.F0 * 1.6) + 8;
  const std::vector<double> g = stream.normals(count);
  const double T0 = process.T0();
  double t = stream.uniform() * T0 * 0.5;
  std::vector<int> onsets;
  for (std::size_t k = 0; k < count; ++k) {
    const double deviation = process.jitter * std::clamp(g[k], -2.5, 2.5);
    const double at =
        process.metronome ? t + static_cast<double>(k) * T0 + deviation * T0 / std::sqrt(2.0) : t;
    if (!process.metronome) t += T0 * std::max(0.35, 1 + deviation);
    const double onset = std::nearbyint(at);
    if (onset >= 0) onsets.push_back(static_cast<int>(onset));
  }
  return onsets;
}

std::vector<double> draw_amplitudes(const ClickProcess& process, std::size_t count, SplitMix& stream) {
  const double rho = process.amplitude_rho, fresh = std::sqrt(1 - rho * rho);
  std::vector<double> amplitudes(count);
  double a = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double w = stream.normal();
    a = k == 0 ? w : rho * a + fresh * w;
    amplitudes[k] = std::max(0.25, 1 + process.amplitude_cv * a);
  }
  return amplitudes;
}

}  // namespace

double ClickProcess::T0() const { return kAnalysisRate / F0; }

std::vector<SimulatedClick> draw_clicks(const ClickProcess& process, double seconds, SplitMix& stream) {
  const std::vector<int> onsets = draw_onsets(process, seconds, stream);
  const std::size_t n = onsets.size();
  const std::vector<double> amplitudes = draw_amplitudes(process, n, stream);
  const std::vector<double> miss = stream.uniforms(n), twice = stream.uniforms(n),
                            rebound = stream.uniforms(2 * n), second = stream.uniforms(n);
  const double T0 = process.T0();
  std::vector<SimulatedClick> impacts, doubles, bounces;
  for (std::size_t k = 0; k < n; ++k) {
    if (miss[k] < process.miss) continue;
    const int P = onsets[k];
    const double beta = amplitudes[k];
    impacts.push_back({P, beta, ClickKind::kImpact});
    if (twice[k] < process.twice)
      doubles.push_back({P + static_cast<int>(T0 * (0.35 + 0.15 * second[k])), beta * (0.6 + 0.3 * second[k]),
                         ClickKind::kDouble});
    if (const auto& b = process.bounce)
      bounces.push_back(
          {P + static_cast<int>(T0 * (b->delay_low + (b->delay_high - b->delay_low) * rebound[2 * k])),
           beta * (b->strength_low + (b->strength_high - b->strength_low) * rebound[2 * k + 1]),
           ClickKind::kBounce});
  }
  std::vector<SimulatedClick> all = impacts;
  all.insert(all.end(), doubles.begin(), doubles.end());
  all.insert(all.end(), bounces.begin(), bounces.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.P < b.P; });
  const auto end = static_cast<int>(std::nearbyint(seconds * kAnalysisRate));
  all.erase(std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.P >= end; }), all.end());
  return all;
}

}  // namespace rigsound::analysis
