#include <fmt/format.h>

#include <cmath>

#include "chain/clip_analysis.hpp"
#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/click_likeness.hpp"
#include "clicks/drilling_test.hpp"
#include "clicks/selection.hpp"
#include "clicks/whitening.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/factors.hpp"
#include "denoise/initial_nmf.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kPasses = 2;
// Impacts deep in noise are found from some random starts and not from others. A later start needs
// clearer evidence, or music would have three tries.
constexpr unsigned kStarts = 3;
constexpr double kFirstTolerance = 1, kLaterTolerance = 0.5;
constexpr int kRoughIterations = 90;  // of step 6, where its result only guides the next search

struct MeanPsd {
  Eigen::ArrayXd S, N;
};

MeanPsd mean_over_time(const PsdPair& psd) {
  return {psd.S.cast<double>().rowwise().mean(), psd.N.cast<double>().rowwise().mean()};
}

/// What each modelled power explains of the recorded one: the model's own sum is up to 1.5 dB above it in
/// bins where clicks decay otherwise than the activations.
MeanPsd recorded_shares(const Spectrogram& X, const PsdPair& psd) {
  MeanPsd mean = mean_over_time(psd);
  const Eigen::ArrayXd recorded = X.abs2().cast<double>().rowwise().mean();
  const Eigen::ArrayXd ratio = recorded / (mean.S + mean.N).max(1e-30);
  mean.S *= ratio, mean.N *= ratio;
  return mean;
}

void dump_detection(const Dump& dump, const std::string& pass, const Eigen::ArrayXd& y,
                    const Candidates& candidates, const ClickTrain& train) {
  dump.signal(pass + "_whitened", y);
  Eigen::ArrayXXd z(candidates.z.size(), 2);
  z.col(0) = Eigen::ArrayXd::LinSpaced(z.rows(), 0, static_cast<double>(z.rows() - 1)) * kCandidateBlock /
             kAnalysisRate;
  z.col(1) = candidates.z;
  dump.table(pass + "_statistic", "time_s,z", z);
  dump.train(pass, train);
}

/// What a split would sound like, and its mean powers.
void dump_split(const Dump& dump, const std::string& step, const Spectrogram& X, const PsdPair& psd,
                size_t length) {
  if (!dump) return;
  const std::vector<float> drilling = inverse_stft(wiener(X, psd), length, kChainStft);
  dump.signal(step + "_drilling",
              Eigen::Map<const Eigen::ArrayXf>(drilling.data(), static_cast<long>(length)).cast<double>());
  const MeanPsd mean = mean_over_time(psd);
  Eigen::ArrayXXd powers(mean.S.size(), 3);
  powers.col(0) = Eigen::ArrayXd::LinSpaced(powers.rows(), 0, kAnalysisRate / 2);
  powers.col(1) = mean.S;
  powers.col(2) = mean.N;
  dump.table(step + "_powers", "frequency_hz,S,N", powers);
}

/// Steps 2 to 5: one search for clicks through the whitener that the modelled powers suggest.
DrillingEvidence detect(const std::vector<float>& x, const MeanPsd& psd, const std::string& pass,
                        FitEffort effort, const Dump& dump) {
  const Eigen::ArrayXd A = noise_aware_whitener(psd.S, psd.N), y = whiten(x, A);
  const Candidates candidates = find_candidates(y);
  const Selection selection = select_clicks(candidates, kDrillingRates);
  DrillingEvidence evidence;
  if (selection.block.size() >= kFewestFitted) evidence.clicks = fit_clicks(y, candidates, selection, effort);
  evidence.total = selection.total;
  evidence.surplus = selection.surplus;
  if (effort == FitEffort::kFull) evidence.fast_total = fast_total(candidates);
  dump_detection(dump, pass, y, candidates, evidence.clicks);
  return evidence;
}

CsNmfOptions rough_options() {
  CsNmfOptions options;
  options.iterations = kRoughIterations;
  return options;
}

/// For the last pass: by then the clicks' envelope is known well enough to choose the decays by it.
CsNmfOptions final_options(const ClickTrain& clicks) {
  CsNmfOptions options;
  options.decays = decays_around(clicks);
  return options;
}

/// What the powers modelled by step 6 add to the evidence.
void add_model_evidence(const PowerSpectrogram& power, const Factors& factors, DrillingEvidence& evidence) {
  const Eigen::ArrayXf near = frames_near_clicks(evidence.clicks, power.frames);
  evidence.background_alone = mean_divergence(power, background_nmf(power), near);
  evidence.with_clicks = mean_divergence(power, factors, near);
  evidence.irregularity = irregularity(evidence.clicks);
  evidence.likeness = click_likeness(power, evidence.clicks);
}

void dump_evidence(const Dump& dump, const std::string& pass, const DrillingEvidence& e) {
  Eigen::ArrayXXd figures(1, 10);
  figures << static_cast<double>(e.clicks.P.size()), e.total, e.surplus, e.fast_total, e.irregularity,
      e.likeness.dispersion, e.likeness.rise, e.likeness.rhythm, e.background_alone, e.with_clicks;
  dump.table(
      pass + "_evidence",
      "clicks,total,surplus,fast_total,irregularity,dispersion,rise,rhythm,background_alone,with_clicks",
      figures);
}

ClipSplit split_without_denoising(const std::vector<float>& x, const Dump& dump) {
  const PowerSpectrogram power = power_spectrogram(stft(x, kChainStft));
  ClipSplit split;
  split.signal_psd = power.P.leftCols(power.frames).cast<double>().rowwise().mean() * power.scale;
  split.noise_psd = Eigen::ArrayXd::Zero(split.signal_psd.size());
  DrillingEvidence evidence = detect(x, {split.signal_psd, split.noise_psd}, "only", FitEffort::kFull, dump);
  if (evidence.clicks.P.size() >= kFewestFitted)
    add_model_evidence(power, cs_nmf(power, evidence.clicks, rough_options()), evidence);
  dump_evidence(dump, "only", evidence);
  split.reason = no_drilling_reason(evidence, kFirstTolerance);
  split.clicks = std::move(evidence.clicks);
  split.drilling = x;
  return split;
}

/// Steps 1 to 6 from one random start.
ClipSplit split_from(unsigned start, const ChainOptions& options, const std::vector<float>& x,
                     const Spectrogram& X, const PowerSpectrogram& power, const Dump& dump) {
  InitialNmfOptions initial;
  initial.seed = options.seed + start;
  const PsdPair blind = modelled_psd(initial_nmf(power, initial), power);
  dump_split(dump, "blind", X, blind, x.size());
  PsdPair psd = blind;
  ClipSplit split;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::string name = fmt::format("pass{}", pass + 1);
    const bool last = pass + 1 == kPasses;
    const FitEffort effort = last ? FitEffort::kFull : FitEffort::kRough;
    DrillingEvidence evidence = detect(x, mean_over_time(psd), name, effort, dump);
    const bool enough = evidence.clicks.P.size() >= kFewestFitted;
    if (enough) {
      const Factors factors =
          cs_nmf(power, evidence.clicks, last ? final_options(evidence.clicks) : rough_options());
      psd = modelled_psd(factors, power);
      if (last) add_model_evidence(power, factors, evidence);
    }
    dump_split(dump, name, X, psd, x.size());
    if (last || !enough) {
      dump_evidence(dump, name, evidence);
      split.reason = no_drilling_reason(evidence, start == 0 ? kFirstTolerance : kLaterTolerance);
    }
    split.clicks = std::move(evidence.clicks);
    if (!enough) break;
  }
  if (!split.reason.empty() && !options.labelled) psd = blind;
  split.drilling = inverse_stft(wiener(X, psd), x.size(), kChainStft);
  const MeanPsd mean = recorded_shares(X, psd);
  split.signal_psd = mean.S;
  split.noise_psd = mean.N;
  return split;
}

}  // namespace

ClipSplit split_by_click_nmf(const std::vector<float>& x, const ChainOptions& options, const Dump& dump) {
  if (!options.denoise) return split_without_denoising(x, dump);
  const Spectrogram X = stft(x, kChainStft);
  const PowerSpectrogram power = power_spectrogram(X);
  const ClipSplit first = split_from(0, options, x, X, power, dump);
  if (first.reason.empty()) return first;
  for (unsigned start = 1; start < kStarts; ++start) {
    const ClipSplit later = split_from(start, options, x, X, power, dump);
    if (later.reason.empty()) return later;
  }
  return first;
}

}  // namespace rigsound::analysis
