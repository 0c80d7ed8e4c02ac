#include "chain/clip_analysis.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "clicks/drilling_test.hpp"
#include "clicks/envelope.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/energy.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kDither = 1e-4f;  // of the RMS: keeps digital silence out of the logarithms

struct NormalisedClip {
  std::vector<float> x;  ///< zero mean, RMS 1, dithered
  float level = 1;       ///< RMS that was divided out
};

NormalisedClip normalise(const std::vector<float>& mono, unsigned seed) {
  const Eigen::Map<const Eigen::ArrayXf> in(mono.data(), static_cast<long>(mono.size()));
  const Eigen::ArrayXd centred = in.cast<double>() - in.cast<double>().mean();
  NormalisedClip clip;
  clip.level = static_cast<float>(std::sqrt(std::max(centred.square().mean(), 1e-20)));
  clip.x.reserve(mono.size());
  std::mt19937_64 bits(seed);
  for (const double sample : centred) {
    const float uniform = static_cast<float>(static_cast<double>(bits() >> 11) * 0x1p-53) - 0.5f;
    clip.x.push_back(static_cast<float>(sample) / clip.level + kDither * std::sqrt(12.0f) * uniform);
  }
  return clip;
}

std::vector<double> scaled(const Eigen::ArrayXd& power, double factor) {
  const Eigen::ArrayXd product = power * factor;
  return {product.begin(), product.end()};
}

/// Amplitudes in the units of the recording: the train's energy becomes that of the drilling.
void calibrate(const std::vector<float>& drilling, ClickTrain& train) {
  double modelled = 0;
  for (const double beta : train.beta) modelled += beta * beta;
  if (modelled <= 0) return;
  const double gain = std::sqrt(dsp::energy(drilling) / (modelled * envelope_energy(train.envelope)));
  for (double& beta : train.beta) beta *= gain;
}

/// What speaks against the most likely window.
std::string doubt(const ClipMachine& split) {
  if (split.clicks.P.size() < kFewestDrillingClicks)
    return fmt::format("{} clicks, expected {} or more", split.clicks.P.size(), kFewestDrillingClicks);
  const auto best =
      std::max_element(split.verdict.begin(), split.verdict.end(),
                       [](const auto& a, const auto& b) { return a.probability < b.probability; });
  return fmt::format("with a probability of {:.2f} at most, {}", best->probability, best->objections);
}

ChainResult result_of(ClipMachine split, float level, const ChainOptions& options) {
  ChainResult result;
  const bool enough = split.clicks.P.size() >= kFewestDrillingClicks;
  result.drilling_found = drills(split.verdict) && enough;
  if (!result.drilling_found) result.reason = doubt(split);
  for (const JudgedWindow& w : split.verdict)
    result.verdict.push_back({static_cast<double>(w.window.begin) / kAnalysisRate,
                              static_cast<double>(w.window.end) / kAnalysisRate, w.probability});
  if (options.labelled || (may_drill(split.verdict) && enough)) result.clicks = std::move(split.clicks);
  const double square = static_cast<double>(level) * level;
  result.signal_psd = scaled(split.signal_psd, square);
  result.noise_psd = scaled(split.noise_psd, square);
  result.output_psd = scaled(mean_power(split.drilling, kChainStft), square);
  for (float& sample : split.drilling) sample *= level;
  calibrate(split.drilling, result.clicks);
  result.drilling = std::move(split.drilling);
  return result;
}

}  // namespace

std::vector<ChainResult> analyse_clip(const std::vector<float>& mono, const std::vector<Segment>& windows,
                                      const ChainOptions& options) {
  const NormalisedClip clip = normalise(mono, options.seed);
  const Dump dump(options.dump);
  std::vector<ClipMachine> machines;
  if (options.method == Method::kPaper)
    machines.push_back(split_by_paper(clip.x, windows, options, dump));
  else
    machines = split_by_click_nmf(clip.x, windows, options, dump);
  std::vector<ChainResult> results;
  for (ClipMachine& machine : machines) results.push_back(result_of(std::move(machine), clip.level, options));
  return results;
}

}  // namespace rigsound::analysis
