#include "clip_analysis.hpp"

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/drilling_test.hpp"
#include "clicks/envelope.hpp"
#include "clicks/selection.hpp"
#include "clicks/whitening.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/initial_nmf.hpp"
#include "denoise/stft.hpp"
#include "denoise/wiener.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kCsIterations[] = {90, 225};  // first pass, second pass
constexpr float kDither = 1e-4f;            // of the RMS: keeps digital silence out of the logarithms

struct NormalisedClip {
  std::vector<float> x;  ///< zero mean, RMS 1, dithered
  float level = 1;       ///< RMS that was divided out
};

NormalisedClip normalise(const std::vector<float>& mono, unsigned seed) {
  const Eigen::Map<const Eigen::ArrayXf> in(mono.data(), static_cast<long>(mono.size()));
  const Eigen::ArrayXd centred = in.cast<double>() - in.cast<double>().mean();
  NormalisedClip clip;
  clip.level = static_cast<float>(std::sqrt(std::max(centred.square().mean(), 1e-20)));
  std::mt19937_64 bits(seed);
  for (const double sample : centred) {
    const float uniform = static_cast<float>(static_cast<double>(bits() >> 11) * 0x1p-53) - 0.5f;
    clip.x.push_back(static_cast<float>(sample) / clip.level + kDither * std::sqrt(12.0f) * uniform);
  }
  return clip;
}

Eigen::ArrayXd mean_power(const Grid& psd) { return psd.cast<double>().rowwise().mean(); }

std::vector<double> scaled(const Eigen::ArrayXd& power, double factor) {
  const Eigen::ArrayXd product = power * factor;
  return {product.begin(), product.end()};
}

/// One look for clicks through the whitener that the modelled powers suggest.
ClickTrain detect(const std::vector<float>& x, const PsdPair& psd, std::string& reason) {
  const Eigen::ArrayXd y = whiten(x, noise_aware_whitener(mean_power(psd.S), mean_power(psd.N)));
  const Candidates candidates = find_candidates(y);
  const Selection selection = select_clicks(candidates);
  reason = no_drilling_reason(selection);
  return reason.empty() ? fit_clicks(y, candidates, selection) : ClickTrain{};
}

/// Amplitudes in the units of the recording: the train's energy becomes that of the drilling.
void calibrate(const std::vector<float>& drilling, ClickTrain& train) {
  double energy = 0, modelled = 0;
  for (const float x : drilling) energy += static_cast<double>(x) * x;
  for (const double beta : train.beta) modelled += beta * beta;
  const double gain = std::sqrt(energy / std::max(modelled * envelope_energy(train.envelope), 1e-30));
  for (double& beta : train.beta) beta *= gain;
}

}  // namespace

ChainResult analyse_clip(const std::vector<float>& mono, const ChainOptions& options) {
  const NormalisedClip clip = normalise(mono, options.seed);
  const Spectrogram X = stft(clip.x, kChainStft);
  const PowerSpectrogram power = power_spectrogram(X);
  InitialNmfOptions initial;
  initial.seed = options.seed;
  PsdPair psd = modelled_psd(initial_nmf(power, initial), power);
  ChainResult result;
  for (const int iterations : kCsIterations) {
    ClickTrain train = detect(clip.x, psd, result.reason);
    if (train.P.size() < 4) break;
    CsNmfOptions cs;
    cs.iterations = iterations;
    psd = modelled_psd(cs_nmf(power, train, cs), power);
    result.clicks = std::move(train);
  }
  result.drilling_found = result.reason.empty();
  if (!result.drilling_found) result.clicks = {};
  const Spectrogram Y = wiener(X, psd);
  result.drilling = inverse_stft(Y, mono.size(), kChainStft);
  for (float& sample : result.drilling) sample *= clip.level;
  calibrate(result.drilling, result.clicks);
  const double square = static_cast<double>(clip.level) * clip.level;
  result.signal_psd = scaled(mean_power(psd.S), square);
  result.noise_psd = scaled(mean_power(psd.N), square);
  result.output_psd = scaled(mean_power(Y.abs2()), square);
  return result;
}

}  // namespace rigsound::analysis
