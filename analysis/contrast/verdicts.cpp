#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "rigsound/analysis/contrast.hpp"

namespace rigsound::analysis {
namespace {

struct FeedSide {
  const char *name, *way, *where;  ///< of the situation, of the feed towards it, of it against normal
  Reach Contrast::*reach;
  double SceneOptions::*threshold_bar;
  int sign;
};
constexpr FeedSide kSides[] = {
    {"overfeed", "up", "above", &Contrast::over, &SceneOptions::overfeed_bar, 1},
    {"underfeed", "down", "below", &Contrast::under, &SceneOptions::underfeed_bar, -1},
};

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// The highest share told right on one side, %.
double best_percent(const Contrast& c, const FeedSide& side) {
  double best = 0;
  for (const FeedFigures& f : c.feed)
    if (f.of > 0 && (f.feed_bar - c.plan.points.normal) * side.sign > 0)
      best = std::max(best, 100.0 * f.right / f.of);
  return best;
}

std::string against_threshold(double bar, const char* name) {
  const double beyond = std::round(bar);
  if (beyond == 0) return fmt::format("just where the rig begins to call it {}", name);
  return fmt::format("{:.0f} bar {} the rig calls it {}", std::fabs(beyond), beyond < 0 ? "before" : "after",
                     name);
}

std::string feed_verdict(const Contrast& c, const FeedSide& side) {
  const Reach& reach = c.*side.reach;
  const double normal = c.plan.points.normal;
  if (!reach.found)
    return fmt::format(
        "{} cannot be heard: nowhere {} normal are more than {:.0f} % of one-second excerpts told "
        "from it (chance is 50 %).",
        capital(side.name), side.where, best_percent(c, side));
  const double at = normal + side.sign * reach.away_bar, threshold = c.plan.scene.*side.threshold_bar;
  const double ends[] = {normal + side.sign * reach.low_bar, normal + side.sign * reach.high_bar};
  return fmt::format(
      "A trainee can hear {} from {:.0f} bar {} ({:.0f} to {:.0f} with 95 % confidence): {:.0f} bar {} "
      "normal "
      "({:g} bar), {}.",
      side.name, at, side.way, std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), reach.away_bar,
      side.where, normal,
      against_threshold(side.sign * (at - threshold), side.name) + fmt::format(" ({:g} bar)", threshold));
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

/// "normal and overfeed"
std::string both(const SubjectGroup& group, const PairFigures& pair) {
  return group.subjects[pair.first].subject.name + " and " + group.subjects[pair.second].subject.name;
}

std::string group_verdict(const SubjectGroup& group, const char* all) {
  std::string failing;
  for (const PairFigures& pair : group.pairs)
    if (!pair.told_apart()) failing += (failing.empty() ? "" : "; ") + both(group, pair);
  return failing.empty() ? fmt::format("{} can be told apart.", all)
                         : fmt::format("Not told apart: {}.", failing);
}

std::string played_from(const SubjectFigures& a, const SubjectFigures& b) {
  if (a.subject.banks.empty() || b.subject.banks.empty()) return "";
  if (a.subject.banks == b.subject.banks)
    return fmt::format("; both are played from bank {}", bank_list(a.subject));
  return fmt::format("; played from banks {} and {}", bank_list(a.subject), bank_list(b.subject));
}

void add_warnings(const Contrast& c, const SubjectGroup& group, std::vector<std::string>& lines) {
  for (const PairFigures& pair : group.pairs) {
    if (pair.told_apart()) continue;
    const SubjectFigures &a = group.subjects[pair.first], &b = group.subjects[pair.second];
    lines.push_back(
        fmt::format("{}: warning: {} cannot be told from {}: {} told right (chance is 50 %), third octaves "
                    "{:.2f} dB apart "
                    "where two runs of one sound are {:.2f} dB{}",
                    c.plan.sound_set.string(), b.subject.name, a.subject.name, percent(pair.right),
                    pair.third_octave_db, pair.third_octave_floor_db, played_from(a, b)));
  }
}

}  // namespace

std::string bank_list(const ContrastSubject& subject) {
  const std::vector<std::string>& banks = subject.banks;
  if (banks.empty()) return "";
  if (banks.size() == 1) return banks[0];
  if (banks.size() == 2) return banks[0] + " and " + banks[1];
  return fmt::format("{}, {} and {} more", banks[0], banks[1], banks.size() - 2);
}

std::vector<std::string> contrast_verdicts(const Contrast& c) {
  std::vector<std::string> verdicts;
  for (const FeedSide& side : kSides) verdicts.push_back(feed_verdict(c, side));
  verdicts.push_back(group_verdict(c.situations, "All five situations"));
  if (!c.rods.pairs.empty()) verdicts.push_back(group_verdict(c.rods, "Strings of 1, 6 and 20 rods"));
  if (!c.rocks.pairs.empty()) verdicts.push_back(group_verdict(c.rocks, "All rocks"));
  return verdicts;
}

std::vector<std::string> contrast_warnings(const Contrast& c) {
  std::vector<std::string> lines;
  for (const SubjectGroup* group : {&c.situations, &c.rods, &c.rocks}) add_warnings(c, *group, lines);
  for (const FeedSide& side : kSides)
    if (!(c.*side.reach).found)
      lines.push_back(fmt::format("{}: warning: {} cannot be heard at any feed {} normal",
                                  c.plan.sound_set.string(), side.name, side.where));
  return lines;
}

}  // namespace rigsound::analysis
