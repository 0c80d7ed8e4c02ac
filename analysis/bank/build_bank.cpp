#include <algorithm>
#include <cmath>
#include <iterator>

#include "bank/candidates.hpp"
#include "bank/click_choice.hpp"
#include "bank/click_extraction.hpp"
#include "bank/equaliser.hpp"
#include "bank/recorded_levels.hpp"
#include "bank/statistics.hpp"
#include "clicks/drilling_test.hpp"
#include "rigsound/analysis/bank_builder.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/dsp/energy.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kFade = 256;  // samples at the end of a click
constexpr double kLtasRangeDb = 50, kModulationRangeDb = 35;
constexpr double kProofSeconds = 4;
constexpr std::uint64_t kProofSeed = 11;  // not one of those the equaliser measured

/// Fades the end out and sets the L2 norm to one.
void finish(std::vector<float>& click) {
  const std::size_t fade = std::min(kFade, click.size() / 4);
  for (std::size_t n = 0; n < fade; ++n)
    click[click.size() - 1 - n] *= static_cast<float>(n) / static_cast<float>(fade);
  dsp::divide(click.data(), click.size(), std::sqrt(dsp::energy(click)));
}

std::vector<Click> finished(std::vector<std::vector<float>> clicks) {
  for (std::vector<float>& click : clicks) finish(click);
  return {std::make_move_iterator(clicks.begin()), std::make_move_iterator(clicks.end())};
}

/// The mean envelope of the segments, each weighed by its clicks.
void set_envelope(const Segments& segments, ClickBank& bank) {
  double weight = 0, bend = 0;
  for (const DrillingSegment& s : segments) {
    const auto w = static_cast<double>(s.last - s.first);
    const ClickEnvelope& e = s.result.clicks.envelope;
    weight += w;
    bank.attack_samples += w * e.attack_samples, bank.decay += w * e.decay,
        bend += w * e.attack_bend * e.attack_samples;
  }
  bank.attack_samples /= weight;
  bank.decay /= weight;
  bank.attack_bend = bend / weight / std::max(bank.attack_samples, 1.0);
}

Series<double> norms_of(const Segments& segments, const std::vector<ClickCandidate>& candidates) {
  Series<double> norms(segments.size());
  for (const ClickCandidate& c : candidates) norms[c.segment].push_back(c.norm);
  return norms;
}

BankFigures figures_of(const Segments& segments, const ClickBank& bank, const BandLevels& target,
                       const BandLevels& denoised) {
  BankFigures f;
  double energy = 0, frames = 0;
  for (const DrillingSegment& s : segments) {
    energy += dsp::energy(s.result.drilling.all());
    frames += static_cast<double>(s.result.drilling.size());
  }
  f.rate_hz = bank.sample_rate / bank.mean_gap_samples;
  f.level_db = 10 * std::log10(energy / frames);
  f.snr_db = signal_to_noise_db(segments);
  f.decay_s = (bank.attack_samples + std::log(1000.0) / bank.decay) / bank.sample_rate;
  for (const auto& click : bank.clicks)
    f.longest_click_s = std::max(f.longest_click_s, static_cast<double>(click.size()) / bank.sample_rate);
  const std::vector<float> proof = resynthesise(bank, kProofSeconds, kProofSeed).sound;
  const BandLevels played = third_octave_levels(proof);
  f.ltas_error_db = mean_difference_db(target, played, kLtasRangeDb, Difference::kCentred);
  f.ltas_denoised_error_db = mean_difference_db(denoised, played, kLtasRangeDb, Difference::kCentred);
  f.modulation_error_db = mean_difference_db(recorded_modulation(segments), modulation_levels(proof),
                                             kModulationRangeDb, Difference::kAbsolute);
  return f;
}

}  // namespace

BuiltBank build_bank(const SegmentedResult& recording, Method method, int count, const std::string& part) {
  const Segments segments = learnable(recording.drilling);
  const std::size_t found = recording.joined.clicks.P.size();
  const std::vector<ClickCandidate> candidates = click_candidates(segments);
  if (found < kFewestDrillingClicks || candidates.size() < 2)
    throw InputError(
        part, "too few clicks to learn from, expected at least " + std::to_string(kFewestDrillingClicks));

  BuiltBank built;
  ClickBank& bank = built.bank;
  bank.sample_rate = kAnalysisRate;
  set_envelope(segments, bank);
  set_amplitude_statistics(norms_of(segments, candidates), bank);
  Series<int> onsets;
  for (const DrillingSegment& s : segments) onsets.push_back(own_onsets(s));

  const auto wanted = static_cast<std::size_t>(count);
  const BandLevels denoised = recorded_levels(segments),
                   target = method == Method::kPaper ? denoised : given_back(segments, denoised);
  if (method == Method::kPaper) {
    set_plain_gap_statistics(onsets, bank);
    bank.amplitude_correlation = 0;
    bank.clicks = finished(extract_whitened(segments, candidates, choose_by_room(candidates, wanted)));
  } else {
    set_gap_statistics(onsets, bank);
    bank.clicks =
        finished(extract_masked(segments, candidates, choose_by_cover(segments, candidates, wanted)));
    const ImpactPairs pairs(bank);
    equalise(bank, pairs, target);
    set_level(bank, pairs, drilling_power(segments) * power(target) / power(denoised));
  }
  built.figures = figures_of(segments, bank, target, denoised);
  built.figures.clicks_found = static_cast<int>(found);
  built.figures.segments = recording.segments;
  built.figures.segments_drilling = static_cast<int>(recording.drilling.size());
  return built;
}

}  // namespace rigsound::analysis
