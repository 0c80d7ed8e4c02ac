#include <fmt/format.h>

#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/drilling_test.hpp"
#include "clicks/selection.hpp"
#include "clicks/whitening.hpp"
#include "clip_split.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/initial_nmf.hpp"
#include "denoise/stft.hpp"
#include "denoise/wiener.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kCsIterations[] = {90, 225};  // first pass, second pass

struct MeanPsd {
  Eigen::ArrayXd S, N;
};

MeanPsd mean_over_time(const PsdPair& psd) {
  return {psd.S.cast<double>().rowwise().mean(), psd.N.cast<double>().rowwise().mean()};
}

void dump_train(const Dump& dump, const std::string& pass, const ClickTrain& train) {
  Eigen::ArrayXXd clicks(train.P.size(), 2);
  for (long i = 0; i < clicks.rows(); ++i) clicks.row(i) << train.P[i] / kAnalysisRate, train.beta[i];
  dump.table(pass + "_clicks", "time_s,beta", clicks);
  Eigen::ArrayXXd envelope(1, 4);
  envelope << train.envelope.N_a, train.envelope.alpha_a, train.envelope.alpha_d, train.T_0;
  dump.table(pass + "_envelope", "N_a,alpha_a,alpha_d,T_0", envelope);
}

void dump_statistic(const Dump& dump, const std::string& pass, const Candidates& candidates) {
  Eigen::ArrayXXd z(candidates.z.size(), 2);
  z.col(0) = Eigen::ArrayXd::LinSpaced(z.rows(), 0, static_cast<double>(z.rows() - 1)) * kCandidateBlock /
             kAnalysisRate;
  z.col(1) = candidates.z;
  dump.table(pass + "_statistic", "time_s,z", z);
}

/// Steps 2 to 5: one look for clicks through the whitener that the modelled powers suggest.
ClickTrain detect(const std::vector<float>& x, const MeanPsd& psd, const std::string& pass, const Dump& dump,
                  std::string& reason) {
  const Eigen::ArrayXd y = whiten(x, noise_aware_whitener(psd.S, psd.N));
  const Candidates candidates = find_candidates(y);
  const Selection selection = select_clicks(candidates);
  reason = no_drilling_reason(selection);
  const ClickTrain train = reason.empty() ? fit_clicks(y, candidates, selection) : ClickTrain{};
  dump.signal(pass + "_whitened", y);
  dump_statistic(dump, pass, candidates);
  dump_train(dump, pass, train);
  return train;
}

ClipSplit split_without_denoising(const std::vector<float>& x, const Dump& dump) {
  ClipSplit split;
  split.signal_psd = stft(x, kChainStft).abs2().cast<double>().rowwise().mean();
  split.noise_psd = Eigen::ArrayXd::Zero(split.signal_psd.size());
  split.clicks = detect(x, {split.signal_psd, split.noise_psd}, "only", dump, split.reason);
  split.drilling = x;
  return split;
}

}  // namespace

ClipSplit split_by_click_nmf(const std::vector<float>& x, const ChainOptions& options, const Dump& dump) {
  if (!options.denoise) return split_without_denoising(x, dump);
  const Spectrogram X = stft(x, kChainStft);
  const PowerSpectrogram power = power_spectrogram(X);
  InitialNmfOptions initial;
  initial.seed = options.seed;
  PsdPair psd = modelled_psd(initial_nmf(power, initial), power);
  ClipSplit split;
  for (int pass = 0; pass < 2; ++pass) {
    split.clicks = detect(x, mean_over_time(psd), fmt::format("pass{}", pass + 1), dump, split.reason);
    if (!split.reason.empty()) break;
    CsNmfOptions cs;
    cs.iterations = kCsIterations[pass];
    psd = modelled_psd(cs_nmf(power, split.clicks, cs), power);
  }
  split.drilling = inverse_stft(wiener(X, psd), x.size(), kChainStft);
  const MeanPsd mean = mean_over_time(psd);
  split.signal_psd = mean.S;
  split.noise_psd = mean.N;
  return split;
}

}  // namespace rigsound::analysis
