#include "bank/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "clicks/period.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kFewClicksFound = 15;
constexpr double kLowSnrDb = -3;
constexpr double kDecayShare = 0.5;  // of the time to -60 dB: a click cut this short stops audibly
constexpr double kLtasErrorDb = 2, kModulationErrorDb = 6;
constexpr double kRateSlack = 0.05,
                 kLevelSlackDb = 2;  // what two recordings of the same thing may differ by
constexpr double kLevelApartDb = 6;  // between banks of a series no feed makes as much

/// `b` stands between `a` and `c` and yet lies outside of both by more than the slack.
bool out_of_order(double a, double b, double c, double slack) {
  return b > std::max(a, c) + slack || b < std::min(a, c) - slack;
}

std::string with_rods(const AnalysedPart& p) {
  return p.part.label.rods == 1 ? "with 1 rod" : fmt::format("with {} rods", p.part.label.rods);
}

std::string at_feed(const AnalysedPart& p) {
  const Label& label = p.part.label;
  return fmt::format("in {}", name(label.situation)) +
         (label.feed_bar > 0 ? fmt::format(" at {:g} bar", label.feed_bar) : "");
}

/// What puts a bank right whose recording had another gain than the others.
std::string gain_text(double db) { return fmt::format("gain_db = {:.1f} in soundset.toml evens it out", db); }

/// A bank between its neighbours in a series; `place` says where in it a bank stands.
void check_triple(const AnalysedPart& a, AnalysedPart& b, const AnalysedPart& c,
                  std::string (*place)(const AnalysedPart&), const char* doubt) {
  const BankFigures &x = a.figures, &y = b.figures, &z = c.figures;
  if (out_of_order(std::log(x.rate_hz), std::log(y.rate_hz), std::log(z.rate_hz), kRateSlack))
    b.warnings.push_back(fmt::format("{:.1f} strikes/s {}, but {:.1f} {} and {:.1f} {}: {}", y.rate_hz,
                                     place(b), x.rate_hz, place(a), z.rate_hz, place(c), doubt));
  if (out_of_order(x.level_db, y.level_db, z.level_db, kLevelSlackDb))
    b.warnings.push_back(
        fmt::format("level {:.1f} dB {}, but {:.1f} {} and {:.1f} {}: {} Or another gain: {}", y.level_db,
                    place(b), x.level_db, place(a), z.level_db, place(c), doubt,
                    gain_text(0.5 * (x.level_db + z.level_db) - y.level_db)));
}

using PartsByPlace = std::multimap<double, AnalysedPart*>;

/// Of the banks [first, last) at one place of a series the one recorded at the feed nearest to that of `b`.
const AnalysedPart& nearest_in_feed(PartsByPlace::const_iterator first, PartsByPlace::const_iterator last,
                                    const AnalysedPart& b) {
  const auto apart = [&b](const auto& entry) {
    return std::fabs(entry.second->part.label.feed_bar - b.part.label.feed_bar);
  };
  return *std::min_element(first, last, [&](const auto& x, const auto& y) {
            return apart(x) < apart(y);
          })->second;
}

/// Every bank between two that stand at other places of the series.
void check_order(const PartsByPlace& series, std::string (*place)(const AnalysedPart&), const char* doubt) {
  for (auto b = series.begin(); b != series.end(); ++b) {
    const auto first = series.lower_bound(b->first), after = series.upper_bound(b->first);
    if (first == series.begin() || after == series.end()) continue;
    const double below = std::prev(first)->first, above = after->first;
    check_triple(nearest_in_feed(series.lower_bound(below), first, *b->second), *b->second,
                 nearest_in_feed(after, series.upper_bound(above), *b->second), place, doubt);
  }
}

/// Pressed too hard the hammer is not faster, and hardly pressed it is not louder than in normal drilling.
void check_situation(const AnalysedPart& normal, AnalysedPart& other) {
  const BankFigures &n = normal.figures, &f = other.figures;
  if (other.part.label.situation == Situation::kOverfeed &&
      std::log(f.rate_hz) > std::log(n.rate_hz) + kRateSlack)
    other.warnings.push_back(fmt::format("{:.1f} strikes/s {}, {:.1f} {} ({}): labels swapped?", f.rate_hz,
                                         at_feed(other), n.rate_hz, at_feed(normal), normal.part.bank));
  if (other.part.label.situation == Situation::kUnderfeed && f.level_db > n.level_db + kLevelSlackDb)
    other.warnings.push_back(fmt::format(
        "level {:.1f} dB {}, {:.1f} {} ({}): labels swapped? Or another gain: {}", f.level_db, at_feed(other),
        n.level_db, at_feed(normal), normal.part.bank, gain_text(n.level_db - f.level_db)));
}

/// One machine before one microphone: its drilling is about as loud at every feed.
void check_levels(const std::vector<AnalysedPart*>& series) {
  std::vector<double> levels;
  for (const AnalysedPart* p : series) levels.push_back(p->figures.level_db);
  const double middle = median(levels);
  for (AnalysedPart* p : series) {
    const double apart = p->figures.level_db - middle;
    if (std::fabs(apart) > kLevelApartDb)
      p->warnings.push_back(
          fmt::format("{:.1f} dB {} than the median of its series of {} banks: another gain? {}",
                      std::fabs(apart), apart > 0 ? "louder" : "softer", series.size(), gain_text(-apart)));
  }
}

/// The drilling banks of one rod count and rock.
void check_feed_series(const std::vector<AnalysedPart*>& drilling) {
  PartsByPlace over_feed, normal;
  for (AnalysedPart* p : drilling) {
    if (p->part.label.feed_bar > 0) over_feed.emplace(p->part.label.feed_bar, p);
    if (p->part.label.situation == Situation::kNormal) normal.emplace(0, p);
  }
  check_order(over_feed, at_feed, "is its label right?");
  for (AnalysedPart* p : drilling)
    if (!normal.empty()) check_situation(nearest_in_feed(normal.begin(), normal.end(), *p), *p);
  check_levels(drilling);
}

}  // namespace

std::vector<std::string> lint_bank(const AnalysedPart& part, int wanted_clicks) {
  const BankFigures& f = part.figures;
  std::vector<std::string> warnings;
  if (!f.doubt.empty()) warnings.push_back("it may be no drilling: " + f.doubt);
  if (f.machine_rates_hz.size() > 1)
    warnings.push_back(fmt::format(
        "two machines strike, at {:.1f} and {:.1f} Hz: this is number {}, --machine {} takes the other",
        f.machine_rates_hz[0], f.machine_rates_hz[1], f.machine, 3 - f.machine));
  if (f.clicks_found < kFewClicksFound || part.clicks < wanted_clicks)
    warnings.push_back(fmt::format("too few clicks: {} found, {} in the bank", f.clicks_found, part.clicks));
  if (f.snr_db < kLowSnrDb) warnings.push_back(fmt::format("low SNR: {:.1f} dB", f.snr_db));
  if (f.longest_click_s < kDecayShare * f.decay_s)
    warnings.push_back(fmt::format("clicks are shorter than their decay: {:.0f} ms of {:.0f} ms",
                                   1e3 * f.longest_click_s, 1e3 * f.decay_s));
  if (f.rate_hz < kDrillingRates.slowest_hz || f.rate_hz > kDrillingRates.fastest_hz)
    warnings.push_back(fmt::format("rate out of range: {:.1f} Hz, expected {} to {} Hz", f.rate_hz,
                                   kDrillingRates.slowest_hz, kDrillingRates.fastest_hz));
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
  std::map<std::pair<Situation, std::string>, PartsByPlace> over_rods;
  std::map<std::pair<int, std::string>, std::vector<AnalysedPart*>> drilling;
  for (AnalysedPart& p : parts) {
    const Label& label = p.part.label;
    if (label.rods > 0) over_rods[{label.situation, label.rock}].emplace(label.rods, &p);
    if (label.situation != Situation::kClosedRattling && label.situation != Situation::kOpenRattling)
      drilling[{label.rods, label.rock}].push_back(&p);
  }
  for (const auto& [key, series] : over_rods) check_order(series, with_rods, "is the rod count right?");
  for (const auto& [key, series] : drilling) check_feed_series(series);
}

}  // namespace rigsound::analysis
