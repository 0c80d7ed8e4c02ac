#include "contrast/contrast_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figure_row.hpp"

namespace rigsound::tools {
namespace {

using namespace analysis;

void print_group(const char* title, const SubjectGroup& group) {
  if (group.pairs.empty()) return;
  fmt::print("{:<36} {:>8} {:>8} {:>8}\n", title, "rate/s", "sone", "phon");
  for (const SubjectFigures& s : group.subjects)
    fmt::print("{:<36} {:8.2f} {:8.2f} {:8.1f}\n", s.subject.name, s.rate_hz, s.loudness_sone,
               s.loudness_phon);
  fmt::print("\n{:<36} {:>19} {:>19} {:>15} {:>8} {:>8}\n", "apart (two runs of one sound)",
             "third octaves, dB", "modulation, dB", "rate, %", "phon", "right, %");
  for (const PairFigures& p : group.pairs)
    fmt::print("{:<36} {:10.2f} ({:6.2f}) {:10.2f} ({:6.2f}) {:7.1f} ({:5.1f}) {:+8.1f} {:8.0f}{}\n",
               group.subjects[p.first].subject.name + " - " + group.subjects[p.second].subject.name,
               p.third_octave_db, p.third_octave_floor_db, p.modulation_db, p.modulation_floor_db,
               100 * p.rate, 100 * p.rate_floor, p.phon, 100 * p.right,
               p.told_apart() ? "" : "  not told apart");
  fmt::print("\n");
}

void print_feed(const Contrast& c) {
  fmt::print("{:>8} {:>18} {:>15} {:>8} {:>8} {:>8} {:>9}\n", "feed,bar", "third octaves, dB",
             "modulation, dB", "rate/s", "sone", "phon", "right, %");
  for (const FeedFigures& f : c.feed)
    fmt::print("{:8g} {:18.2f} {:15.2f} {:8.2f} {:8.2f} {:8.1f} {:>9}\n", f.feed_bar, f.third_octave_db,
               f.modulation_db, f.rate_hz, f.loudness_sone, f.loudness_phon,
               f.of > 0 ? fmt::format("{:.0f}", 100.0 * f.right / f.of) : "normal");
  fmt::print("\n");
}

Json group_json(const SubjectGroup& group) {
  Json json{{"sounds", Json::array()}, {"pairs", Json::array()}};
  for (const SubjectFigures& s : group.subjects)
    json["sounds"].push_back({{"name", s.subject.name},
                              {"feed_bar", s.subject.setting.feed_bar},
                              {"rods", s.subject.setting.rods},
                              {"rock", s.subject.setting.rock},
                              {"banks", s.subject.banks},
                              {"rate_hz", s.rate_hz},
                              {"loudness_sone", s.loudness_sone},
                              {"loudness_phon", s.loudness_phon}});
  for (const PairFigures& p : group.pairs)
    json["pairs"].push_back({{"first", group.subjects[p.first].subject.name},
                             {"second", group.subjects[p.second].subject.name},
                             {"third_octave_db", p.third_octave_db},
                             {"third_octave_floor_db", p.third_octave_floor_db},
                             {"modulation_db", p.modulation_db},
                             {"modulation_floor_db", p.modulation_floor_db},
                             {"rate_percent", 100 * p.rate},
                             {"rate_floor_percent", 100 * p.rate_floor},
                             {"loudness_difference_phon", p.phon},
                             {"right", p.right},
                             {"told_apart", p.told_apart()}});
  return json;
}

/// `sign`: on which side of normal. null when no feed is far enough.
Json reach_json(const Contrast& c, const Reach& reach, int sign) {
  if (!reach.found) return nullptr;
  const double normal = c.plan.points.normal, low = normal + sign * reach.low_bar,
               high = normal + sign * reach.high_bar;
  return {{"feed_bar", normal + sign * reach.away_bar},
          {"low_bar", std::min(low, high)},
          {"high_bar", std::max(low, high)},
          {"away_from_normal_bar", reach.away_bar}};
}

Json feed_json(const FeedFigures& f) {
  Json json{{"feed_bar", f.feed_bar},           {"third_octave_db", f.third_octave_db},
            {"modulation_db", f.modulation_db}, {"rate_hz", f.rate_hz},
            {"loudness_sone", f.loudness_sone}, {"loudness_phon", f.loudness_phon}};
  if (f.of > 0) json["right"] = static_cast<double>(f.right) / f.of, json["excerpts"] = f.of;
  return json;
}

}  // namespace

void print_contrast_table(const Contrast& c) {
  print_group("situation", c.situations);
  print_group("rods", c.rods);
  print_group("rock", c.rocks);
  print_feed(c);
  fmt::print("Loudness: ISO 532-1, {:g} dB SPL at the ear for a sine of full scale.\n",
             c.options.full_scale_db_spl);
  for (const std::string& verdict : contrast_verdicts(c)) fmt::print("{}\n", verdict);
}

void print_contrast_json(const Contrast& c) {
  Json json;
  json["sound_set"] = c.plan.sound_set.string();
  json["options"] = {{"seconds", c.options.seconds},
                     {"runs", c.options.runs},
                     {"seed", c.options.seed},
                     {"db_spl_of_full_scale_sine", c.options.full_scale_db_spl}};
  json["situations"] = group_json(c.situations);
  json["rods"] = group_json(c.rods);
  json["rocks"] = group_json(c.rocks);
  for (const FeedFigures& f : c.feed) json["feed"].push_back(feed_json(f));
  json["heard_from"] = {{"overfeed", reach_json(c, c.over, 1)}, {"underfeed", reach_json(c, c.under, -1)}};
  json["verdicts"] = contrast_verdicts(c);
  json["warnings"] = contrast_warnings(c);
  print_document(json);
}

}  // namespace rigsound::tools
