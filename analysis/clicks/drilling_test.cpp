#include "clicks/drilling_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "clicks/click_fit.hpp"
#include "clicks/envelope.hpp"
#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kToldFrom = 0.25;     // of the sum: figures that bear on it
constexpr double kUnexplained = 0.01;  // divergence over that of noise: less leaves nothing to explain
constexpr double kMostHidden = 1;      // by a codec or noise: no reason by itself
constexpr double kFew_hz = 8;          // slower clicks are few, and so is all that they have over chance
constexpr double kNoExcuse = 1.5;      // above chance a click, for a unit of divergence
constexpr double kOneSound = 0.04;     // dispersion: no drill found in noise has less than 0.05
constexpr RateRange kPulses{130, 400};
constexpr double kFastestDrill_hz = 122;  // as found: kDrillingRates and what a period is known to
constexpr double kSamePeriod = 0.8;       // of the clicks' own gap
constexpr std::size_t kGapsAround = 4;    // on either side

/// What one figure says against drilling: 0 where nine drills in ten are or better, 1 where it alone is much.
struct Objection {
  double weight;
  std::string text;
};

using Objections = std::array<Objection, kObjections>;
constexpr std::size_t kSwell = 1;  // of them

double square_above_zero(double x) { return x > 0 ? x * x : 0; }

double on_a_scale(double value, double usual, double limit) {
  return square_above_zero((value - usual) / (limit - usual));
}

double by_ratio(double value, double usual, double limit) {
  return on_a_scale(std::log(std::max(value, 1e-3)), std::log(usual), std::log(limit));
}

// `usual` and `limit` of all: first by logistic regression of the weights' sum, then rounded, and eased where
// a drill was refused. The drills and other sounds of tests/bench/verdict, and beside them ids 0-31 and
// 200-231, 44 drills of low modes and five recordings of drills. Of the drills none at 0 dB or more had a
// jitter above 0.13, nine in ten a rise in 2.1 ms, a dispersion of 0.2 and 1 a click above chance; of those
// with a rate above 8 Hz none had less than 12 above it altogether.

Objection swells(const DrillingEvidence& e) {
  const double rise = rise_samples(e.clicks.envelope), rise_ms = 1000 * rise / kAnalysisRate;
  // Long in itself, unless its bands rise steeply together (an engine's by a neper, a slow click's by two),
  // and long for its period.
  const double steepness = square_above_zero(std::max(1.0, e.likeness.rise));
  return {std::min(by_ratio(rise_ms / steepness, 2.1, 4.2),
                   by_ratio(rise / e.clicks.mean_gap_samples, 0.1, 0.17)),
          fmt::format("it swells in {:.1f} ms instead of striking", rise_ms)};
}

/// Beside clicks that are all one sound there is no other: what is left then is of their own form.
double more_than_noise(const DrillingEvidence& e) {
  return e.likeness.dispersion < kOneSound ? 0 : std::max(0.0, e.left_over - kNoiseDivergence);
}

Objection near_chance(const DrillingEvidence& e, double rate) {
  const double surplus = e.surplus / static_cast<double>(e.clicks.P.size());
  // Noise brings blows near chance. Where more than noise is left beside the clicks it excuses less.
  const double clear = surplus - kNoExcuse * more_than_noise(e);
  return {std::max(on_a_scale(clear, 1, 0.3), rate > kFew_hz ? on_a_scale(e.surplus, 25, 8) : 0),
          fmt::format("its clicks are {:.1f} above chance", surplus)};
}

Objection unexplained(const DrillingEvidence& e) {
  const double changes = std::max(e.background_alone - kNoiseDivergence, kUnexplained);
  const double explained = (e.background_alone - e.with_clicks) / changes;
  const double hidden = std::min(on_a_scale(explained, 0.76, 0.4), kMostHidden);
  const double others = on_a_scale(more_than_noise(e), 0.15, 0.4);
  if (others > hidden) return {others, "more than noise is left beside its clicks"};
  return {hidden, fmt::format("a repeated click explains {:.0f} % of its changes", 100 * explained)};
}

/// The same waveform again, unless it rises out of what was before; much of it again where hardly anything
/// rises; or at uneven times, or though its clicks differ, however steeply.
Objection repeats(const DrillingEvidence& e) {
  const auto again = [&e](double usual, double limit) { return on_a_scale(e.repetition, usual, limit); };
  return {std::max({std::min(again(0.7, 0.85), on_a_scale(e.likeness.rise, 1.6, 1.0)),
                    std::min(again(0.4, 0.65), on_a_scale(e.likeness.rise, 0.4, 0.15)),
                    std::min(again(0.85, 0.96), on_a_scale(e.irregularity, 0.02, 0.07)),
                    std::min(again(0.45, 0.65), on_a_scale(e.likeness.dispersion, 0.25, 0.35))}),
          "its waveform comes again and again, like that of a voice, an engine or a creak"};
}

Objections objections(const DrillingEvidence& e) {
  const double rate = kAnalysisRate / e.clicks.mean_gap_samples;
  const double pulses = e.fast_total / std::max(e.total, 1.0);
  return {{
      {by_ratio(rate, 12, 6.8), fmt::format("{:.1f} clicks a second are slow", rate)},
      swells(e),
      near_chance(e, rate),
      {on_a_scale(pulses, 0.05, 0.6), "it pulses faster than 130 Hz, like a voice or a tone"},
      {by_ratio(e.likeness.dispersion, 0.2, 0.4), "its clicks do not resemble one another"},
      {on_a_scale(e.likeness.rise, 0.35, 0), "its bands do not rise together"},
      {std::max(on_a_scale(e.likeness.rhythm, 0.1, 0.45), on_a_scale(e.strength_rhythm, 2.7, 4.2)),
       "its clicks follow a rhythm"},
      {on_a_scale(e.jitter, 0.11, 0.15),
       fmt::format("its gaps differ by {:.0f} %", 100 * std::expm1(e.jitter))},
      unexplained(e),
      repeats(e),
  }};
}

double probability_given(const std::array<double, kObjections>& weights) {
  const double against = std::inner_product(weights.begin(), weights.end(), kCoefficients.begin(), 0.0);
  return 1 / (1 + std::exp(against - kBias));
}

}  // namespace

double irregularity(const ClickTrain& clicks) {
  const std::vector<double> gaps = gaps_of(clicks.P);
  const double T = median(gaps);
  std::vector<double> deviation;
  for (const double gap : gaps) deviation.push_back(std::fabs(std::log(gap / T)));
  return upper_median(deviation);
}

double jitter(const ClickTrain& clicks) {
  const std::vector<double> gaps = gaps_of(clicks.P);
  std::vector<double> deviation;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const auto first = gaps.begin() + static_cast<long>(i - std::min(i, kGapsAround)),
               end = gaps.begin() + static_cast<long>(std::min(gaps.size(), i + kGapsAround + 1));
    deviation.push_back(std::fabs(std::log(gaps[i] / median({first, end}))));
  }
  return upper_median(deviation);
}

double fast_total(const Candidates& candidates, const ClickTrain& clicks) {
  const Selection fast = select_clicks(candidates, kPulses);
  const double gap = fast.mean_gap_blocks * kCandidateBlock;
  const bool drills_so_fast = clicks.mean_gap_samples >= kAnalysisRate / kFastestDrill_hz;
  return drills_so_fast && gap > kSamePeriod * clicks.mean_gap_samples ? 0 : fast.total;
}

Eigen::ArrayXf frames_near_clicks(const ClickTrain& train, int frames) {
  Eigen::ArrayXf near = Eigen::ArrayXf::Zero(frames);
  for (const int P : train.P) {
    const int first = std::max(0, static_cast<int>((P - 0.5 * train.mean_gap_samples) / kChainStft.hop));
    const int last =
        std::min(frames - 1, static_cast<int>((P + 2 * train.mean_gap_samples) / kChainStft.hop));
    if (first <= last) near.segment(first, last - first + 1) = 1;
  }
  return near;
}

std::array<double, kObjections> objection_weights(const DrillingEvidence& e) {
  std::array<double, kObjections> weights{};
  const Objections against = objections(e);
  std::transform(against.begin(), against.end(), weights.begin(),
                 [](const Objection& o) { return std::min(o.weight, kMostWeight); });
  return weights;
}

double drilling_probability(const DrillingEvidence& e) {
  return e.clicks.P.size() < kFewestFitted ? 0 : probability_given(objection_weights(e));
}

double drilling_promise(const DrillingEvidence& e) {
  if (e.clicks.P.size() < kFewestFitted) return 0;
  auto weights = objection_weights(e);
  weights[kSwell] = 0;
  return probability_given(weights);
}

std::string objections_to(const DrillingEvidence& e) {
  if (e.clicks.P.size() < kFewestFitted)
    return fmt::format("{} clicks, expected {} or more", e.clicks.P.size(), kFewestFitted);
  Objections against = objections(e);
  for (std::size_t i = 0; i < kObjections; ++i) against[i].weight *= kCoefficients[i];
  const double sum = std::accumulate(against.begin(), against.end(), 0.0,
                                     [](double total, const Objection& o) { return total + o.weight; });
  std::stable_sort(against.begin(), against.end(),
                   [](const Objection& a, const Objection& b) { return a.weight > b.weight; });
  std::string reason;
  for (const Objection& objection : against)
    if (reason.empty() || objection.weight > kToldFrom * sum)
      reason += (reason.empty() ? "" : ", ") + objection.text;
  return reason;
}

}  // namespace rigsound::analysis
