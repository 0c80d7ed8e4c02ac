#include "tool_fit/blow.hpp"

#include "numeric/quantile.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {
namespace {

constexpr std::size_t kStep = 24;       // samples, 0.5 ms
constexpr std::size_t kLongest = 2000;  // steps, 1 s
constexpr double kRise = 8;             // the next blow is this much louder than the quiet before it
constexpr double kStandsOut = 4;        // and the strongest this much louder than the middle of it all

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

std::optional<Blow> strongest_blow(const std::vector<float>& x) {
  const std::vector<double> rms = envelope(x);
  if (rms.size() < 40) return std::nullopt;
  const auto peak = static_cast<std::size_t>(std::max_element(rms.begin(), rms.end() - 20) - rms.begin());
  if (!(rms[peak] > kStandsOut * upper_median(rms))) return std::nullopt;
  Blow blow;
  blow.onset = foot(rms, peak) * kStep;
  const std::size_t end = next_rise(rms, peak) * kStep;
  for (std::size_t i = 0; i < kBeforeBlow; ++i)
    blow.sound.push_back(blow.onset + i < kBeforeBlow ? 0
                                                      : static_cast<double>(x[blow.onset + i - kBeforeBlow]));
  for (std::size_t n = blow.onset; n < end; ++n) blow.sound.push_back(static_cast<double>(x[n]));
  return blow;
}

}  // namespace rigsound::analysis
