#include "rigsound/analysis/tool_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "numeric/nelder_mead.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/input_error.hpp"
#include "tool_fit/band_analyser.hpp"
#include "tool_fit/decay_evidence.hpp"
#include "tool_fit/equaliser_fit.hpp"
#include "tool_fit/impact_sound.hpp"
#include "tool_fit/partials.hpp"
#include "tool_fit/steel_search.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kAudible_db = 40;  // bands this far below the loudest do not count
constexpr double kLevelWeight =
    0.6;  // of the spectrum against the decays; the equaliser corrects the spectrum later
constexpr double kMostDifference_db = 20;
constexpr int kFewestTold = 3;              // third octaves: two loops and a shelf need as many decays
constexpr double kOverlongWeight_db = 100;  // of modes that ring e times longer than was heard

/// What the search moves, and between which bounds.
enum Parameter : std::size_t {
  kLossT,
  kShelfT,
  kCorner,
  kLossL,
  kShelfL,
  kBalance,
  kStrikeWidth,
  kHighpass,
  kContact,
  kCount
};

struct Range {
  double low, high, start, step;
};

const Range kRanges[kCount] = {
    {std::log(0.0005), std::log(0.5), std::log(0.11), 0.5},      // ln(1 - k_T)
    {0.05, 1, 0.8, 0.15},                                        // shelf gain, transversal
    {std::log(1000), std::log(12000), std::log(6000), 0.3},      // shelf corner, Hz
    {std::log(0.0005), std::log(0.5), std::log(0.06), 0.5},      // ln(1 - k_L)
    {0.05, 1, 0.8, 0.15},                                        // shelf gain, longitudinal
    {-40, 40, 0, 6},                                             // longitudinal over transversal, dB
    {std::log(60e-6), std::log(1.5e-3), std::log(227e-6), 0.3},  // pulse width, s
    {std::log(20), std::log(4000), std::log(800), 0.5},          // high-pass, Hz
    {0, 0.12, 0.03, 0.03},                                       // share of k_T lost in contact
};

void set(ToolModel& model, const std::vector<double>& u) {
  Decay& T = model.transversal;
  Decay& L = model.longitudinal;
  T.reflection_max = 1 - std::exp(u[kLossT]);
  T.reflection_min = T.reflection_max * (1 - u[kContact]);
  L.reflection_min = L.reflection_max = 1 - std::exp(u[kLossL]);
  T.shelf_gain = u[kShelfT], L.shelf_gain = u[kShelfL];
  T.shelf_hz = L.shelf_hz = std::exp(u[kCorner]);
  const double ratio = std::pow(10, u[kBalance] / 20);
  model.voicing.transversal_mix = 1 / (1 + ratio);
  model.voicing.longitudinal_mix = ratio / (1 + ratio);
  model.voicing.highpass_hz = std::exp(u[kHighpass]);
  model.strike.width_s = std::exp(u[kStrikeWidth]);
}

/// Puts the model's decays into loops that were designed before: a few cents off, but a thousand times
/// sooner.
void put_decays(const ToolModel& model, ToolDesign& design) {
  const double shelf = std::tan(M_PI * model.transversal.shelf_hz / design.sample_rate);
  const auto put = [shelf](const Decay& decay, LoopDesign& loop) {
    loop.filters.shelf = shelf;
    loop.filters.shelf_gain = decay.shelf_gain;
    loop.reflection_min = decay.reflection_min, loop.reflection_max = decay.reflection_max;
  };
  put(model.transversal, design.transversal);
  put(model.longitudinal, design.longitudinal);
  design.made_for = {model.bar, model.transversal, model.longitudinal};
}

class Comparison {
 public:
  Comparison(const RecordedImpact& impact, double highest_hz)
      : samples_(impact.sound.size()), analyser_(highest_hz), recorded_(analyser_.analyse(impact.sound)) {
    DecayEvidence evidence(impact);
    const double loudest = *std::max_element(recorded_.level_db.begin(), recorded_.level_db.end());
    for (std::size_t b = 0; b < recorded_.level_db.size(); ++b) {
      if (!(recorded_.level_db[b] > loudest - kAudible_db)) continue;
      const BandEvidence band = evidence.band(centre_hz(b));
      if (!band.share.told()) continue;
      const double level = recorded_.level_db[b] - loudest;
      used_.push_back(b);
      bands_.push_back({centre_hz(b), level, level, level + 10 * std::log10(band.share.low),
                        level + 10 * std::log10(band.share.high), band.decay});
    }
  }

  /// What the recording tells of each used band; the model's levels are not in it yet.
  const std::vector<FittedBand>& bands() const { return bands_; }

  /// How much longer than the recording bears out the modes ring, mean of ln.
  double overlong(const std::vector<TunedMode>& modes) const {
    double sum = 0;
    for (const TunedMode& mode : modes) sum += std::max(0.0, std::log(mode.t60_s / longest_s(mode.model_hz)));
    return modes.empty() ? 0 : sum / static_cast<double>(modes.size());
  }

  BandProfile profile(const ToolModel& model) { return analyser_.analyse(one_impact(model, samples_)); }

  /// Recorded minus model per used band, without its mean.
  std::vector<double> level_difference(const BandProfile& model) const {
    std::vector<double> difference;
    for (const std::size_t b : used_) difference.push_back(recorded_.level_db[b] - model.level_db[b]);
    const double mean =
        std::accumulate(difference.begin(), difference.end(), 0.0) / static_cast<double>(difference.size());
    for (double& d : difference) d -= mean;
    return difference;
  }

  double cost(const BandProfile& model) const {
    double level = 0, decay = 0;
    for (const double d : level_difference(model)) level += std::min(kMostDifference_db, std::fabs(d));
    for (const std::size_t b : used_) decay += decay_difference(model, b);
    return (kLevelWeight * level + decay) / static_cast<double>(used_.size());
  }

  double centre_hz(std::size_t band) const { return analyser_.centre_hz()[band]; }

 private:
  /// The upper bound of the band's T60, or the lower one where there is no upper. Where nothing was heard,
  /// the longest of all.
  double longest_s(double hz) const {
    double longest = 0;
    for (const FittedBand& band : bands_) {
      const double bound = band.decay.told() ? band.decay.high_s : band.decay.low_s;
      if (band.holds(hz) && bound > 0) return bound;
      longest = std::max(longest, bound);
    }
    return longest;
  }

  /// Mean |difference| of the two courses in one band, the model's moved to the recording's level and with
  /// the recording's own floor under it.
  double decay_difference(const BandProfile& model, std::size_t b) const {
    const std::vector<double>& course = recorded_.decay_db[b];
    if (course.empty()) return 0;
    const double floor = std::pow(10, *std::min_element(course.begin(), course.end()) / 10);
    const double move = recorded_.level_db[b] - model.level_db[b];
    double sum = 0;
    for (std::size_t i = 0; i < course.size(); ++i) {
      const double there = 10 * std::log10(std::pow(10, (model.decay_db[b][i] + move) / 10) + floor);
      sum += std::min(kMostDifference_db, std::fabs(course[i] - there));
    }
    return sum / static_cast<double>(course.size());
  }

  std::size_t samples_;
  BandAnalyser analyser_;
  BandProfile recorded_;
  std::vector<std::size_t> used_;
  std::vector<FittedBand> bands_;  // as many
};

/// The sound of one impact can be too short, or too close to its noise, to tell how a steel decays.
void require_told(const Comparison& comparison, const RecordedImpact& impact, const std::string& file) {
  const std::vector<FittedBand>& bands = comparison.bands();
  if (bands.empty())
    throw InputError(
        file,
        "no third octave of the impact stands out of what is heard before it, expected one impact "
        "with less noise, alone");
  const auto told =
      std::count_if(bands.begin(), bands.end(), [](const FittedBand& band) { return band.decay.told(); });
  if (told >= kFewestTold) return;
  const FittedBand& slowest = *std::max_element(
      bands.begin(), bands.end(), [](const auto& x, const auto& y) { return x.decay.low_s < y.decay.low_s; });
  const double length_s = static_cast<double>(impact.sound.size() - kBeforeImpact) / kAnalysisRate;
  throw InputError(
      file, fmt::format(
                "tells the decay of {} third octaves: the impact is heard for {:.0f} ms{}, expected {} that "
                "fall by {:.0f} dB above the noise: longer sound of one impact, or less noise",
                told, 1000 * length_s,
                slowest.decay.low_s > 0 ? fmt::format(" (T60 at least {:.2g} s at {:.0f} Hz)",
                                                      slowest.decay.low_s, slowest.centre_hz)
                                        : "",
                kFewestTold, kHeardFall_db));
}

/// Decays, mix, pulse width and high-pass: the best of searches that start from short, middle and long
/// decays.
void fit_decays(Comparison& comparison, ToolModel& model, const Progress& progress) {
  constexpr int kEach = 400, kFiner = 1200, kAll = 4 * kEach + 2 * kFiner;  // evaluations, at most
  int done = 0;
  ToolModel trial = model;
  trial.designs = {design_tool(model, kAnalysisRate)};
  const auto cost = [&](const std::vector<double>& u) {
    set(trial, u);
    put_decays(trial, trial.designs.front());
    if (progress) progress(std::min(1.0, static_cast<double>(++done) / kAll));
    return comparison.cost(comparison.profile(trial)) +
           kOverlongWeight_db * comparison.overlong(tuned_modes(trial, trial.designs.front()));
  };
  SimplexOptions options;
  std::vector<double> start;
  for (const Range& range : kRanges) {
    options.step.push_back(range.step), options.tolerance.push_back(1e-4);
    options.lower.push_back(range.low), options.upper.push_back(range.high);
    start.push_back(range.start);
  }
  std::vector<double> best = start;
  double least = 1e18;
  int stage_end = 0;
  for (const double loss : {0.15, 0.05, 0.015, 0.004}) {
    std::vector<double> u = start;
    u[kLossT] = u[kLossL] = std::log(loss);
    options.evaluations = kEach;
    u = nelder_mead(cost, u, options);
    if (const double c = cost(u); c < least) least = c, best = u;
    done = std::max(done, stage_end += kEach);  // a search that ended early
  }
  for (const double shrink : {0.5, 0.25}) {
    SimplexOptions finer = options;
    for (double& step : finer.step) step *= shrink;
    finer.evaluations = kFiner;
    best = nelder_mead(cost, best, finer);
    done = std::max(done, stage_end += kFiner);
  }
  set(model, best);
}

bool tunable(const ToolModel& model) {
  try {
    design_tool(model, kAnalysisRate);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// A sound that does not ring ends the search at decays no loop can be tuned with; a livelier steel can.
void make_tunable(ToolModel& model) {
  for (int i = 0; i < 20 && !tunable(model); ++i)
    for (Decay* decay : {&model.transversal, &model.longitudinal}) {
      decay->shelf_gain = std::sqrt(decay->shelf_gain);
      decay->reflection_max = 1 - 0.8 * (1 - decay->reflection_max);
      decay->reflection_min = 1 - 0.8 * (1 - decay->reflection_min);
    }
}

/// As loud as an impact on the default steel, whatever the fit did to mix and equaliser.
void level_out(ToolModel& model, std::size_t samples) {
  const auto energy = [samples](const ToolModel& m) {
    double sum = 0;
    for (const double x : one_impact(m, samples)) sum += x * x;
    return sum;
  };
  model.voicing.level *= std::sqrt(energy(ToolModel{}) / energy(model));
}

void note_error(const Comparison& comparison, const BandProfile& model, ToolFit& fit) {
  const std::vector<double> difference = comparison.level_difference(model);
  fit.bands = comparison.bands();
  for (std::size_t i = 0; i < difference.size(); ++i) {
    fit.bands[i].model_db -= difference[i];
    fit.mean_error_db += std::fabs(difference[i]) / static_cast<double>(difference.size());
    fit.worst_error_db = std::max(fit.worst_error_db, std::fabs(difference[i]));
  }
}

Bar steel_of(const RecordedImpact& impact, const std::string& file, const Bar& given, double highest_hz,
             ToolFit& fit) {
  if (given.length_m > 0 && given.diameter_m > 0) return given;
  const auto found = find_steel(clear_partials(impact.sound, highest_hz), given, highest_hz);
  if (!found)
    throw InputError(file,
                     "the modes of the steel are not clear enough to tell its size, expected --length and "
                     "--diameter");
  fit.estimated = true;
  fit.matched_modes = found->matched;
  return found->bar;
}

}  // namespace

bool FittedBand::holds(double hz) const { return std::fabs(std::log2(hz / centre_hz)) <= 1.0 / 6; }

const FittedBand* ToolFit::band_at(double hz) const {
  const auto band =
      std::find_if(bands.begin(), bands.end(), [hz](const FittedBand& b) { return b.holds(hz); });
  return band == bands.end() ? nullptr : &*band;
}

ToolFit fit_tool(const Recording& recording, const std::string& file, const ToolFitOptions& options,
                 const Progress& progress) {
  const auto impact = strongest_impact(recording.mono);
  if (!impact)
    throw InputError(file, "no impact stands out, expected the recorded sound of an impact on a steel");
  const double highest_hz = std::min(18000.0, 0.45 * recording.source_rate);
  ToolFit fit;
  fit.onset_s = static_cast<double>(impact->onset) / kAnalysisRate;
  fit.length_s = static_cast<double>(impact->sound.size() - kBeforeImpact) / kAnalysisRate;
  fit.model.bar = steel_of(*impact, file, {options.length_m, options.diameter_m}, highest_hz, fit);
  require_valid(fit.model, kAnalysisRate);
  Comparison comparison(*impact, highest_hz);
  require_told(comparison, *impact, file);
  fit_decays(comparison, fit.model, progress);
  make_tunable(fit.model);
  std::vector<double> centres;
  for (const FittedBand& band : comparison.bands()) centres.push_back(band.centre_hz);
  fit.model.voicing.equaliser =
      fit_bells(centres, comparison.level_difference(comparison.profile(fit.model)));
  level_out(fit.model, impact->sound.size());
  note_error(comparison, comparison.profile(fit.model), fit);
  return fit;
}

}  // namespace rigsound::analysis
