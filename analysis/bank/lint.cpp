#include "bank/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace rigsound::analysis {
namespace {

constexpr int kFewClicksFound = 15;
constexpr double kLowSnrDb = -3;
constexpr double kDecayShare = 0.5;  // of the time to -60 dB: a click cut this short stops audibly
constexpr double kLowestRateHz = 5, kHighestRateHz = 80;
constexpr double kLtasErrorDb = 2, kModulationErrorDb = 6;
constexpr double kPeriodSlack = 0.05,
                 kLevelSlackDb = 2;  // what two recordings of the same thing may differ by

/// `b` stands between `a` and `c` and yet lies outside of both by more than the slack.
bool out_of_order(double a, double b, double c, double slack) {
  return b > std::max(a, c) + slack || b < std::min(a, c) - slack;
}

void check_triple(const AnalysedPart& a, AnalysedPart& b, const AnalysedPart& c) {
  if (out_of_order(std::log(a.mean_gap_samples), std::log(b.mean_gap_samples), std::log(c.mean_gap_samples),
                   kPeriodSlack))
    b.warnings.push_back(
        fmt::format("T0 of {:.0f} samples is out of order in its rod series: {} has {:.0f}, {} has {:.0f}",
                    b.mean_gap_samples, a.part.bank, a.mean_gap_samples, c.part.bank, c.mean_gap_samples));
  if (out_of_order(a.figures.level_db, b.figures.level_db, c.figures.level_db, kLevelSlackDb))
    b.warnings.push_back(
        fmt::format("level of {:.1f} dB is out of order in its rod series: {} has {:.1f}, {} has {:.1f}",
                    b.figures.level_db, a.part.bank, a.figures.level_db, c.part.bank, c.figures.level_db));
}

using Series = std::multimap<int, AnalysedPart*>;

/// Every bank between two that stand at other places of the series.
void check_rods(const Series& series) {
  for (auto b = series.begin(); b != series.end(); ++b) {
    const auto after = series.upper_bound(b->first), first = series.lower_bound(b->first);
    if (first == series.begin() || after == series.end()) continue;
    check_triple(*std::prev(first)->second, *b->second, *after->second);
  }
}

/// Over the feed there are three places and two rules: pressed too hard the hammer is not faster, and hardly
/// pressed it is not louder than in normal drilling.
void check_feed(const AnalysedPart& normal, AnalysedPart& other) {
  const BankFigures& f = other.figures;
  if (other.part.label.situation == Situation::kOverfeed &&
      std::log(other.mean_gap_samples) < std::log(normal.mean_gap_samples) - kPeriodSlack)
    other.warnings.push_back(
        fmt::format("T0 of {:.0f} samples is out of order in its feed series: {} has {:.0f}",
                    other.mean_gap_samples, normal.part.bank, normal.mean_gap_samples));
  if (other.part.label.situation == Situation::kUnderfeed &&
      f.level_db > normal.figures.level_db + kLevelSlackDb)
    other.warnings.push_back(
        fmt::format("level of {:.1f} dB is out of order in its feed series: {} has {:.1f}", f.level_db,
                    normal.part.bank, normal.figures.level_db));
}

}  // namespace

std::vector<std::string> lint_bank(const AnalysedPart& part, int wanted_clicks) {
  const BankFigures& f = part.figures;
  std::vector<std::string> warnings;
  if (f.clicks_found < kFewClicksFound || part.clicks < wanted_clicks)
    warnings.push_back(fmt::format("too few clicks: {} found, {} in the bank", f.clicks_found, part.clicks));
  if (f.snr_db < kLowSnrDb) warnings.push_back(fmt::format("low SNR: {:.1f} dB", f.snr_db));
  if (f.longest_click_s < kDecayShare * f.decay_s)
    warnings.push_back(fmt::format("clicks are shorter than their decay: {:.0f} ms of {:.0f} ms",
                                   1e3 * f.longest_click_s, 1e3 * f.decay_s));
  if (f.rate_hz < kLowestRateHz || f.rate_hz > kHighestRateHz)
    warnings.push_back(fmt::format("rate out of range: {:.1f} Hz, expected {} to {} Hz", f.rate_hz,
                                   kLowestRateHz, kHighestRateHz));
  if (f.segments_drilling < f.segments)
    warnings.push_back(fmt::format("drilling in {} of {} segments only", f.segments_drilling, f.segments));
  if (f.ltas_error_db > kLtasErrorDb)
    warnings.push_back(
        fmt::format("the synthesis is coloured: third-octave levels off by {:.1f} dB", f.ltas_error_db));
  if (f.modulation_error_db > kModulationErrorDb)
    warnings.push_back(fmt::format("the synthesis moves otherwise: modulation spectrum off by {:.1f} dB",
                                   f.modulation_error_db));
  return warnings;
}

void lint_series(std::vector<AnalysedPart>& parts) {
  std::map<std::pair<Situation, std::string>, Series> over_rods;
  for (AnalysedPart& p : parts)
    if (p.part.label.rods > 0)
      over_rods[{p.part.label.situation, p.part.label.rock}].emplace(p.part.label.rods, &p);
  for (const auto& [key, series] : over_rods) check_rods(series);

  std::map<std::pair<int, std::string>, const AnalysedPart*> normal;
  for (const AnalysedPart& p : parts)
    if (p.part.label.situation == Situation::kNormal)
      normal.emplace(std::make_pair(p.part.label.rods, p.part.label.rock), &p);
  for (AnalysedPart& p : parts) {
    const auto same = normal.find({p.part.label.rods, p.part.label.rock});
    if (same != normal.end()) check_feed(*same->second, p);
  }
}

}  // namespace rigsound::analysis
