#include "tool_fit/impact_sound.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_player.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kStep = 24;           // samples, 0.5 ms
constexpr std::size_t kLongest = 2000;      // steps, 1 s
constexpr std::size_t kMostBefore = 24000;  // samples
constexpr double kRise = 8;                 // the next impact is this much louder than the quiet before it
constexpr double kStandsOut = 4;            // and the strongest this much louder than the middle of it all

std::vector<double> envelope(const std::vector<float>& x) {
  std::vector<double> rms;
  for (std::size_t n = 0; n + kStep <= x.size(); n += kStep) {
    double sum = 0;
    for (std::size_t i = n; i < n + kStep; ++i) sum += static_cast<double>(x[i]) * static_cast<double>(x[i]);
    rms.push_back(std::sqrt(sum / kStep));
  }
  return rms;
}

/// Where the rise to `peak` begins: the last step before it that is below a tenth of it.
std::size_t foot(const std::vector<double>& rms, std::size_t peak) {
  std::size_t at = peak;
  while (at > 0 && peak - at < 20 && rms[at - 1] > 0.1 * rms[peak]) --at;
  return at;
}

/// The first step after `peak` at which the sound rises again.
std::size_t next_rise(const std::vector<double>& rms, std::size_t peak) {
  double quietest = rms[peak];
  const std::size_t end = std::min(rms.size(), peak + kLongest);
  for (std::size_t at = peak + 1; at < end; ++at) {
    quietest = std::min(quietest, rms[at]);
    if (rms[at] > kRise * quietest && rms[at] > 0.2 * rms[peak]) return foot(rms, at);
  }
  return end;
}

}  // namespace

std::optional<RecordedImpact> strongest_impact(const std::vector<float>& x) {
  const std::vector<double> rms = envelope(x);
  if (rms.size() < 40) return std::nullopt;
  const auto peak = static_cast<std::size_t>(std::max_element(rms.begin(), rms.end() - 20) - rms.begin());
  if (!(rms[peak] > kStandsOut * upper_median(rms))) return std::nullopt;
  RecordedImpact impact;
  impact.onset = foot(rms, peak) * kStep;
  const std::size_t from = impact.onset - std::min(impact.onset, kMostBefore);
  impact.before.assign(x.begin() + static_cast<std::ptrdiff_t>(from),
                       x.begin() + static_cast<std::ptrdiff_t>(impact.onset));
  const std::size_t end = next_rise(rms, peak) * kStep;
  for (std::size_t i = 0; i < kBeforeImpact; ++i)
    impact.sound.push_back(
        impact.onset + i < kBeforeImpact ? 0 : static_cast<double>(x[impact.onset + i - kBeforeImpact]));
  for (std::size_t n = impact.onset; n < end; ++n) impact.sound.push_back(static_cast<double>(x[n]));
  return impact;
}

std::vector<double> one_impact(const ToolModel& model, std::size_t samples) {
  ToolModel steady = model;
  steady.strike.bounces = 0;
  steady.strike.amplitude_variation = 0;
  steady.strike.slope_variation = 0;
  ToolPlayer player(steady, kAnalysisRate, 1);
  std::vector<double> sound;
  for (std::size_t start = 0; start < samples; start += kChunk) {
    const bool here = kBeforeImpact >= start && kBeforeImpact < start + kChunk;
    const Impact impact{here ? static_cast<double>(kBeforeImpact - start) : 0.0, 1, 0};
    double out[kChunk];
    player.process({&impact, here ? 1 : 0}, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  sound.resize(samples);
  return sound;
}

}  // namespace rigsound::analysis
