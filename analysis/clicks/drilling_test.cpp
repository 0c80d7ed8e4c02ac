#include "clicks/drilling_test.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "denoise/divergence.hpp"
#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {
namespace {

// Measured on the development clips (ids 100-131, from clean to -6 dB) and on noise, speech, music and rotary
// drills made for the purpose; the remarks give the nearest figure on either side.
constexpr size_t kFewestClicks = 6;
constexpr double kLeastZ = 2.4;     // drills from 2.5, noise with a sharp rise up to 2.0
constexpr double kPlainGain = 0.1;  // divergence explained by the clicks that makes up for a small z
constexpr double kSlowest_hz = 5, kFastest_hz = 85;
constexpr double kLongestAttack =
    0.285;  // of T_0, just below the fit's bound: drills up to 0.2, swells at the bound
constexpr double kLongestAttack_s = 0.006;  // drills up to 2.5 ms, an idling diesel from 6 ms
constexpr double kSteadyTones = 0.5;  // divergence of the background alone: drills from 0.58, a chord 0.3
constexpr double kUnexplained =
    0.05;  // divergence over that of noise, below which there is nothing to explain
constexpr double kLeastExplained = 0.5;  // of it: drills from 0.58, speech up to 0.40
constexpr double kWorstFit = 1.6;        // divergence with clicks: drills up to 1.23, music from 2.1
constexpr double kFastAdvantage = 1.2;   // of the chain's total
constexpr RateRange kPulses{100, 400};

std::string wrong_rate(const DrillingEvidence& e) {
  const double rate = kAnalysisRate / e.clicks.T_0;
  if (rate < kSlowest_hz || rate > kFastest_hz)
    return fmt::format("{:.1f} clicks a second, expected {} to {}", rate, kSlowest_hz, kFastest_hz);
  if (e.fast_total > kFastAdvantage * e.total) return "it pulses faster than 100 Hz, like a voice or a tone";
  return {};
}

std::string no_sharp_rise(const DrillingEvidence& e) {
  const double N_a = e.clicks.envelope.N_a;
  if (N_a < kLongestAttack * e.clicks.T_0 && N_a < kLongestAttack_s * kAnalysisRate) return {};
  return fmt::format("it swells in {:.1f} ms instead of striking", 1000 * N_a / kAnalysisRate);
}

std::string not_explained(const DrillingEvidence& e) {
  if (e.background_alone < kSteadyTones) return "steady tones";
  const double unexplained = e.background_alone - kNoiseDivergence;
  const double explained = (e.background_alone - e.with_clicks) / unexplained;
  if (unexplained > kUnexplained && explained < kLeastExplained)
    return fmt::format("a repeated click explains {:.0f} % of its changes, expected {:.0f} % or more",
                       100 * explained, 100 * kLeastExplained);
  if (e.with_clicks > kWorstFit) return "its clicks do not resemble one another";
  return {};
}

}  // namespace

double fast_total(const Candidates& candidates) { return select_clicks(candidates, kPulses).total; }

Eigen::ArrayXf frames_near_clicks(const ClickTrain& train, int frames) {
  Eigen::ArrayXf near = Eigen::ArrayXf::Zero(frames);
  for (const int P : train.P) {
    const int first = std::max(0, static_cast<int>((P - 0.5 * train.T_0) / kChainStft.hop));
    const int last = std::min(frames - 1, static_cast<int>((P + 2 * train.T_0) / kChainStft.hop));
    if (first <= last) near.segment(first, last - first + 1) = 1;
  }
  return near;
}

std::string no_drilling_reason(const DrillingEvidence& e) {
  if (e.clicks.P.size() < kFewestClicks)
    return fmt::format("{} clicks, expected {} or more", e.clicks.P.size(), kFewestClicks);
  if (e.z < kLeastZ && e.background_alone - e.with_clicks < kPlainGain)
    return fmt::format("its clicks stand out by z = {:.1f} on average, expected {} or more", e.z, kLeastZ);
  for (const auto rule : {wrong_rate, no_sharp_rise, not_explained})
    if (std::string reason = rule(e); !reason.empty()) return reason;
  return {};
}

}  // namespace rigsound::analysis
