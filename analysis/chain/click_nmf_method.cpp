#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "chain/blind_start.hpp"
#include "chain/click_search.hpp"
#include "chain/clip_analysis.hpp"
#include "chain/clip_verdict.hpp"
#include "chain/second_machine.hpp"
#include "clicks/coherent_alignment.hpp"
#include "clicks/drilling_test.hpp"
#include "clicks/second_strikes.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/factors.hpp"
#include "denoise/word_fit.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLost = 0.3;  // of what a chain has over chance, a click
// Promise of the rough clicks' best window. Of 130 drills, 32 of them at -6 dB, none was below 5e-4; of
// 187 other sounds four in five are below this.
constexpr double kPromising = 1e-4;
constexpr double kSameOctave = 1.5;
constexpr double kSlowCost = 0.06;  // times the squared share of noise, chosen on ids 100-131
// Of step 6, where its result only guides the next search. Plain: at -6 dB the envelope that is fitted then
// may be either of two, and which one follows from how far each word has come.
constexpr int kRoughUpdates = 90;

/// Of all power.
double noise_share(const MeanPsd& psd) { return psd.N.sum() / (psd.S.sum() + psd.N.sum()); }

/// What each modelled power explains of the recorded one: the model's own sum is up to 1.5 dB above it in
/// bins where clicks decay otherwise than the activations.
MeanPsd recorded_shares(const Spectrogram& X, MeanPsd mean) {
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
void dump_split(const Dump& dump, const std::string& step, const Spectrogram& X,
                const PowerSpectrogram& power, const Factors& factors, size_t length) {
  if (!dump) return;
  const std::vector<float> drilling =
      inverse_stft(wiener(X, modelled_psd(factors, power)), length, kChainStft);
  dump.signal(step + "_drilling",
              Eigen::Map<const Eigen::ArrayXf>(drilling.data(), static_cast<long>(length)).cast<double>());
  const MeanPsd mean = mean_psd(factors, power);
  Eigen::ArrayXXd powers(mean.S.size(), 3);
  powers.col(0) = Eigen::ArrayXd::LinSpaced(powers.rows(), 0, kAnalysisRate / 2);
  powers.col(1) = mean.S;
  powers.col(2) = mean.N;
  dump.table(step + "_powers", "frequency_hz,S,N", powers);
}

ClickTrain fit(const ClickSearch& found, FitEffort effort, const std::string& pass, const Dump& dump) {
  ClickTrain clicks = fit_found(found, effort);
  dump_detection(dump, pass, found.y, found.candidates, clicks);
  return clicks;
}

Factors rough_factors(const WordFit& clip, const ClickTrain& clicks) {
  CsNmfOptions options;
  options.updates = plain_updates(kRoughUpdates);
  return cs_nmf(clip, {{clicks, kUsualDecays}}, options);
}

/// For the last pass: by then the clicks' envelope is known well enough to choose the decays by it. A slow
/// tail is believed the less the more of the recording is noise: the tails of a clean one are heard.
Factors final_factors(const WordFit& clip, const ClickTrain& clicks, double noise) {
  CsNmfOptions options;
  options.slow_cost = static_cast<float>(kSlowCost * noise * noise);
  return cs_nmf(clip, {{clicks, decays_around(clicks)}}, options);
}

SearchedClip searched(const std::vector<float>& x, const ClickSearch& found, const ClickTrain& clicks,
                      const PowerSpectrogram& power, const Grid& background_alone,
                      const std::optional<Factors>& factors) {
  return {x, found.candidates, clicks, power, background_alone, factors ? &*factors : nullptr};
}

ClipMachine split_without_denoising(const std::vector<float>& x, const std::vector<Segment>& windows,
                                    const Dump& dump) {
  const PowerSpectrogram power = power_spectrogram(stft(x, kChainStft));
  ClipMachine all;
  all.signal_psd = mean_power(power) * power.scale;
  all.noise_psd = Eigen::ArrayXd::Zero(all.signal_psd.size());
  const ClickSearch found = search_clicks(x, {all.signal_psd, all.noise_psd});
  all.clicks = fit(found, FitEffort::kFull, "only", dump);
  std::optional<Factors> factors;
  const WordFit clip(power);
  if (all.clicks.P.size() >= kFewestFitted) factors = rough_factors(clip, all.clicks);
  all.drilling = x;
  all.verdict =
      judge(windows, searched(x, found, all.clicks, power, left_by_background(clip), factors), "only", dump);
  return all;
}

/// A search, its clicks, and step 6 with them; without factors when there are too few.
struct Pass {
  ClickSearch found;
  ClickTrain clicks;
  std::optional<Factors> factors;
};

/// The first pass only guides the second.
Pass first_pass(ClickSearch found, const WordFit& clip, const Dump& dump) {
  Pass pass{std::move(found), {}, {}};
  pass.clicks = fit(pass.found, FitEffort::kRough, "pass1", dump);
  if (pass.clicks.P.size() >= kFewestFitted) pass.factors = rough_factors(clip, pass.clicks);
  return pass;
}

/// Not in 670 clips did a second search that left the first one's octave find the right one.
bool leaves_octave(const ClickSearch& first, const ClickSearch& second) {
  const double ratio = second.selection.mean_gap_blocks / first.selection.mean_gap_blocks;
  return std::max(ratio, 1 / ratio) > kSameOctave;
}

/// `powers`: those of the first. Through them the chain of a narrow band may be lost again, or its octave:
/// then the first search stands.
Pass second_pass(const std::vector<float>& x, const MeanPsd& powers, const WordFit& clip,
                 const ClickSearch& first, const Dump& dump) {
  Pass pass{search_clicks(x, powers), {}, {}};
  const bool lost = pass.found.clearness() < kClear && first.clearness() > pass.found.clearness() + kLost;
  if (lost || leaves_octave(first, pass.found)) pass.found = first;
  pass.clicks = fit(pass.found, FitEffort::kFull, "pass2", dump);
  if (pass.clicks.P.size() >= kFewestFitted)
    pass.factors = final_factors(clip, pass.clicks, noise_share(powers));
  return pass;
}

/// After the verdict, whose figures are those of plain trains.
void refine(const WordFit& clip, ClickTrain refined, Pass& pass) {
  if (refined.P == pass.clicks.P) return;
  pass.clicks = std::move(refined);
  pass.factors = final_factors(clip, pass.clicks, noise_share(mean_psd(*pass.factors, clip.power())));
}

ClipMachine machine_of(const Spectrogram& X, const PowerSpectrogram& power, const Factors& factors,
                       std::vector<JudgedWindow> verdict, ClickTrain clicks, std::size_t length) {
  MeanPsd mean = recorded_shares(X, mean_psd(factors, power));
  return {std::move(verdict), std::move(clicks),
          inverse_stft(wiener(X, modelled_psd(factors, power)), length, kChainStft), std::move(mean.S),
          std::move(mean.N)};
}

/// Each of the two judged as if the other were not there; nothing unless both drill.
std::vector<ClipMachine> split_of_two(const std::vector<float>& x, const std::vector<Segment>& windows,
                                      const Spectrogram& X, const PowerSpectrogram& power,
                                      const TwoMachines& two, const Dump& dump) {
  std::vector<ClipMachine> both;
  for (int k = 0; k < 2; ++k) {
    const FoundMachine& m = two.machine[k];
    const std::string pass = fmt::format("machine{}", k + 1);
    const Factors own = drilling_of_train(two.factors, k), alone = without_other_words(own);
    dump_detection(dump, pass, m.found.y, m.found.candidates, m.clicks);
    const PowerSpectrogram rest = without_other_machine(power, own);
    auto verdict =
        judge(windows, {x, m.found.candidates, m.clicks, rest, left_by_background(WordFit(rest)), &alone},
              pass, dump);
    if (!drills(verdict) || m.clicks.P.size() < kFewestDrillingClicks) return {};
    dump_split(dump, pass, X, power, own, x.size());
    both.push_back(machine_of(X, power, own, std::move(verdict), m.clicks, x.size()));
  }
  return both;
}

/// The rough clicks may be those of a drill.
bool is_promising(const std::vector<JudgedWindow>& verdict) {
  return std::any_of(verdict.begin(), verdict.end(),
                     [](const JudgedWindow& w) { return w.promise >= kPromising; });
}

}  // namespace

std::vector<ClipMachine> split_by_click_nmf(const std::vector<float>& x, const std::vector<Segment>& windows,
                                            const ChainOptions& options, const Dump& dump) {
  if (!options.denoise) return {split_without_denoising(x, windows, dump)};
  const Spectrogram X = stft(x, kChainStft);
  const PowerSpectrogram power = power_spectrogram(X);
  const WordFit clip(power);
  const Grid background_alone = left_by_background(clip);
  const BlindStart start = clearest_start(options, x, clip, background_alone);
  dump_split(dump, "blind", X, power, start.blind, x.size());

  Pass pass = first_pass(start.found, clip, dump);
  const auto judged = [&] {
    return judge(windows, searched(x, pass.found, pass.clicks, power, background_alone, pass.factors),
                 "pass2", dump);
  };
  std::vector<JudgedWindow> verdict;
  if (!options.labelled) verdict = judged();
  const bool go_on = options.labelled || (start.found.clearness() >= kHopeless && is_promising(verdict));
  if (pass.factors && go_on) {
    dump_split(dump, "pass1", X, power, *pass.factors, x.size());
    pass = second_pass(x, mean_psd(*pass.factors, power), clip, start.found, dump);
  }
  if (go_on) verdict = judged();
  if (may_drill(verdict))
    refine(clip, with_second_strikes(pass.found.y, pass.found.candidates, pass.clicks), pass);
  if (drills(verdict))
    if (const auto two = find_second_machine(x, start.found.y, clip, pass.clicks))
      if (auto both = split_of_two(x, windows, X, power, *two, dump); !both.empty()) return both;
  const bool by_clicks = pass.factors && (options.labelled || may_drill(verdict));
  if (by_clicks) refine(clip, aligned_to_waveform(pass.found.y, pass.clicks), pass);
  const Factors& split = by_clicks ? *pass.factors : start.blind;
  dump_split(dump, "pass2", X, power, split, x.size());
  return {machine_of(X, power, split, std::move(verdict), std::move(pass.clicks), x.size())};
}

}  // namespace rigsound::analysis
