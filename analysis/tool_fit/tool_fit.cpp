#include "rigsound/analysis/tool_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "numeric/nelder_mead.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/machine/input_error.hpp"
#include "tool_fit/band_analyser.hpp"
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
    const double loudest = *std::max_element(recorded_.level_db.begin(), recorded_.level_db.end());
    for (std::size_t b = 0; b < recorded_.level_db.size(); ++b)
      if (recorded_.level_db[b] > loudest - kAudible_db) used_.push_back(b);
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

  const BandProfile& recorded() const { return recorded_; }
  double centre_hz(std::size_t band) const { return analyser_.centre_hz()[band]; }
  const std::vector<std::size_t>& used() const { return used_; }

 private:
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
};

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
    return comparison.cost(comparison.profile(trial));
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
  const BandProfile& recorded = comparison.recorded();
  const double loudest = *std::max_element(recorded.level_db.begin(), recorded.level_db.end());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const std::size_t b = comparison.used()[i];
    const double level = recorded.level_db[b] - loudest;
    fit.bands.push_back({comparison.centre_hz(b), level, level - difference[i]});
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
  fit_decays(comparison, fit.model, progress);
  make_tunable(fit.model);
  std::vector<double> centres;
  for (const std::size_t b : comparison.used()) centres.push_back(comparison.centre_hz(b));
  fit.model.voicing.equaliser =
      fit_bells(centres, comparison.level_difference(comparison.profile(fit.model)));
  level_out(fit.model, impact->sound.size());
  note_error(comparison, comparison.profile(fit.model), fit);
  return fit;
}

}  // namespace rigsound::analysis
