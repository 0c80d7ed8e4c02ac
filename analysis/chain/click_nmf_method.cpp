#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "chain/clip_analysis.hpp"
#include "chain/clip_verdict.hpp"
#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/selection.hpp"
#include "clicks/whitening.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/factors.hpp"
#include "denoise/initial_nmf.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr unsigned kStarts = 3;
// What a chain has over chance, a click. Of 32 drills at -6 dB none was below 0.43, of 54 noises and effects
// three in four were below 0.23 and nine in ten below 0.6.
constexpr double kHopeless = 0.3, kClear = 1;
constexpr double kSlowCost = 0.06;    // times the squared share of noise, chosen on ids 100-131
constexpr int kRoughIterations = 90;  // of step 6, where its result only guides the next search

struct MeanPsd {
  Eigen::ArrayXd S, N;
};

/// Of all power.
double noise_share(const MeanPsd& psd) { return psd.N.sum() / (psd.S.sum() + psd.N.sum()); }

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

/// Steps 2 to 4 through the whitener that the modelled powers suggest.
struct Search {
  Eigen::ArrayXd y;
  Candidates candidates;
  Selection selection;

  /// What the chain has over chance, a click.
  double clearness() const {
    return selection.surplus / static_cast<double>(std::max<std::size_t>(selection.block.size(), 1));
  }
};

Search search(const std::vector<float>& x, const MeanPsd& psd) {
  Search found;
  found.y = whiten(x, noise_aware_whitener(psd.S, psd.N));
  found.candidates = find_candidates(found.y);
  found.selection = select_clicks(found.candidates, kDrillingRates);
  return found;
}

/// Step 5; fewer than kFewestFitted clicks: there is nothing to fit.
ClickTrain fit(const Search& found, FitEffort effort, const std::string& pass, const Dump& dump) {
  ClickTrain clicks;
  if (found.selection.block.size() >= kFewestFitted)
    clicks = fit_clicks(found.y, found.candidates, found.selection, effort);
  dump_detection(dump, pass, found.y, found.candidates, clicks);
  return clicks;
}

CsNmfOptions rough_options() {
  CsNmfOptions options;
  options.iterations = kRoughIterations;
  return options;
}

/// For the last pass: by then the clicks' envelope is known well enough to choose the decays by it. A slow
/// tail is believed the less the more of the recording is noise: the tails of a clean one are heard.
CsNmfOptions final_options(const ClickTrain& clicks, double noise) {
  CsNmfOptions options;
  options.decays = decays_around(clicks);
  options.slow_cost = static_cast<float>(kSlowCost * noise * noise);
  return options;
}

SearchedClip searched(const Search& found, const ClickTrain& clicks, const PowerSpectrogram& power,
                      const std::optional<Factors>& factors) {
  return {found.y.size(), found.candidates, clicks, power, factors ? &*factors : nullptr};
}

ClipSplit split_without_denoising(const std::vector<float>& x, const std::vector<Segment>& windows,
                                  const Dump& dump) {
  const PowerSpectrogram power = power_spectrogram(stft(x, kChainStft));
  ClipSplit split;
  split.signal_psd = power.P.leftCols(power.frames).cast<double>().rowwise().mean() * power.scale;
  split.noise_psd = Eigen::ArrayXd::Zero(split.signal_psd.size());
  const Search found = search(x, {split.signal_psd, split.noise_psd});
  split.clicks = fit(found, FitEffort::kFull, "only", dump);
  std::optional<Factors> factors;
  if (split.clicks.P.size() >= kFewestFitted) factors = cs_nmf(power, split.clicks, rough_options());
  split.verdict = judge(windows, searched(found, split.clicks, power, factors), "only", dump);
  split.drilling = x;
  return split;
}

/// A blind split and what a search through it finds.
struct Start {
  PsdPair blind;
  Search found;
};

Start start_from(unsigned seed, const std::vector<float>& x, const PowerSpectrogram& power) {
  InitialNmfOptions initial;
  initial.seed = seed;
  Start start;
  start.blind = modelled_psd(initial_nmf(power, initial), power);
  start.found = search(x, mean_over_time(start.blind));
  return start;
}

/// Impacts deep in noise are found from some random starts and not from others: where the first finds nothing
/// clear, the clearest of several.
Start clearest_start(unsigned seed, const std::vector<float>& x, const PowerSpectrogram& power) {
  Start best = start_from(seed, x, power);
  if (best.found.clearness() >= kClear) return best;
  for (unsigned more = 1; more < kStarts; ++more) {
    Start other = start_from(seed + more, x, power);
    if (other.found.clearness() > best.found.clearness()) best = std::move(other);
  }
  return best;
}

/// A search, its clicks, and step 6 with them; without factors when there are too few.
struct Pass {
  Search found;
  ClickTrain clicks;
  std::optional<Factors> factors;
};

/// The first pass only guides the second.
Pass first_pass(Search found, const PowerSpectrogram& power, const Dump& dump) {
  Pass pass{std::move(found), {}, {}};
  pass.clicks = fit(pass.found, FitEffort::kRough, "pass1", dump);
  if (pass.clicks.P.size() >= kFewestFitted) pass.factors = cs_nmf(power, pass.clicks, rough_options());
  return pass;
}

/// `powers`: those of the first.
Pass second_pass(const std::vector<float>& x, const MeanPsd& powers, const PowerSpectrogram& power,
                 const Dump& dump) {
  Pass pass{search(x, powers), {}, {}};
  pass.clicks = fit(pass.found, FitEffort::kFull, "pass2", dump);
  if (pass.clicks.P.size() >= kFewestFitted)
    pass.factors = cs_nmf(power, pass.clicks, final_options(pass.clicks, noise_share(powers)));
  return pass;
}

}  // namespace

ClipSplit split_by_click_nmf(const std::vector<float>& x, const std::vector<Segment>& windows,
                             const ChainOptions& options, const Dump& dump) {
  if (!options.denoise) return split_without_denoising(x, windows, dump);
  const Spectrogram X = stft(x, kChainStft);
  const PowerSpectrogram power = power_spectrogram(X);
  const Start start = clearest_start(options.seed, x, power);
  dump_split(dump, "blind", X, start.blind, x.size());

  Pass pass = first_pass(start.found, power, dump);
  if (pass.factors && (options.labelled || start.found.clearness() >= kHopeless)) {
    const PsdPair rough = modelled_psd(*pass.factors, power);
    dump_split(dump, "pass1", X, rough, x.size());
    pass = second_pass(x, mean_over_time(rough), power, dump);
  }
  ClipSplit split;
  split.verdict = judge(windows, searched(pass.found, pass.clicks, power, pass.factors), "pass2", dump);
  const bool by_clicks = pass.factors && (options.labelled || drills(split.verdict));
  const PsdPair psd = by_clicks ? modelled_psd(*pass.factors, power) : start.blind;
  dump_split(dump, "pass2", X, psd, x.size());
  split.clicks = std::move(pass.clicks);
  split.drilling = inverse_stft(wiener(X, psd), x.size(), kChainStft);
  const MeanPsd mean = recorded_shares(X, psd);
  split.signal_psd = mean.S;
  split.noise_psd = mean.N;
  return split;
}

}  // namespace rigsound::analysis
