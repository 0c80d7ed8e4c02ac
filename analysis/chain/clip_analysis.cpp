#include "chain/clip_analysis.hpp"

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "clicks/envelope.hpp"
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

}  // namespace

ChainResult analyse_clip(const std::vector<float>& mono, const ChainOptions& options) {
  const NormalisedClip clip = normalise(mono, options.seed);
  const Dump dump(options.dump);
  ClipSplit split = options.method == Method::kPaper ? split_by_paper(clip.x, options, dump)
                                                     : split_by_click_nmf(clip.x, options, dump);
  ChainResult result;
  result.reason = split.reason;
  result.drilling_found = result.reason.empty();
  if (result.drilling_found || options.labelled) result.clicks = std::move(split.clicks);
  const double square = static_cast<double>(clip.level) * clip.level;
  result.signal_psd = scaled(split.signal_psd, square);
  result.noise_psd = scaled(split.noise_psd, square);
  const Spectrogram Y = stft(split.drilling, kChainStft);
  result.output_psd = scaled(Y.abs2().cast<double>().rowwise().mean(), square);
  result.drilling = std::move(split.drilling);
  for (float& sample : result.drilling) sample *= clip.level;
  calibrate(result.drilling, result.clicks);
  return result;
}

}  // namespace rigsound::analysis
