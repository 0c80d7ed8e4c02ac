// What the lint warns about.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "bank/lint.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

AnalysedPart part(const std::string& bank, Situation situation, int rods, double T_0, double level_db) {
  AnalysedPart p;
  p.part.bank = bank;
  p.part.label.situation = situation;
  p.part.label.rods = rods;
  p.mean_gap_samples = T_0;
  p.clicks = 10;
  p.figures = {60, 1, 1, 48000 / T_0, level_db, 10, 0.05, 0.05, 0.3, 0.5, 2, {}, 1, {}};
  return p;
}

bool warns(const std::vector<std::string>& warnings, const std::string& words) {
  for (const std::string& w : warnings)
    if (w.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("lint warns about what it should, and about nothing else") {
  CHECK(lint_bank(part("good", Situation::kNormal, 1, 1200, -20), 10).empty());
  const auto with = [](auto change) {
    AnalysedPart p = part("p", Situation::kNormal, 1, 1200, -20);
    change(p);
    return lint_bank(p, 10);
  };
  CHECK(warns(with([](AnalysedPart& p) { p.figures.clicks_found = 8; }), "too few clicks"));
  CHECK(warns(with([](AnalysedPart& p) { p.clicks = 6; }), "too few clicks"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.snr_db = -5; }), "low SNR"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.longest_click_s = 0.01; }), "shorter than their decay"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.rate_hz = 125; }), "rate out of range"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.segments = 3; }), "1 of 3 segments"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.doubt = "it swells"; }), "may be no drilling: it swells"));
  CHECK(warns(with([](AnalysedPart& p) {
                p.figures.machine_rates_hz = {34, 21}, p.figures.machine = 2;
              }),
              "at 34.0 and 21.0 Hz: this is number 2, --machine 1 takes the other"));
}

TEST_CASE("lint finds the bank that is out of order among rods, and says so in strikes and rods") {
  std::vector<AnalysedPart> rods = {
      part("r1", Situation::kNormal, 1, 1200, -20), part("r3", Situation::kNormal, 3, 1240, -21),
      part("r5", Situation::kNormal, 5, 1500, -22), part("r7", Situation::kNormal, 7, 1320, -23)};
  lint_series(rods);
  CHECK(rods[0].warnings.empty());
  CHECK(rods[1].warnings.empty());
  REQUIRE(rods[2].warnings.size() == 1);
  CHECK(rods[2].warnings[0] ==
        "32.0 strikes/s with 5 rods, but 38.7 with 3 rods and 36.4 with 7 rods: is the rod count right?");
  CHECK(rods[3].warnings.empty());
}

TEST_CASE("lint asks whether underfeed, normal and overfeed are swapped") {
  std::vector<AnalysedPart> feed = {part("u", Situation::kUnderfeed, 1, 1300, -17),
                                    part("n", Situation::kNormal, 1, 48000 / 22.2, -20),
                                    part("o", Situation::kOverfeed, 1, 48000 / 31.4, -22)};
  lint_series(feed);
  REQUIRE(feed[0].warnings.size() == 1);
  CHECK(
      feed[0].warnings[0] ==
      "level -17.0 dB in underfeed, -20.0 in normal (n): labels swapped? Or another gain: gain_db = -3.0 in "
      "soundset.toml evens it out");
  CHECK(feed[1].warnings.empty());
  REQUIRE(feed[2].warnings.size() == 1);
  CHECK(feed[2].warnings[0] == "31.4 strikes/s in overfeed, 22.2 in normal (n): labels swapped?");
}

namespace {

/// Ten bar apart from 50 bar on, as a ramp gives them.
std::vector<AnalysedPart> ramp(std::vector<double> rates_hz, double first_level_db) {
  std::vector<AnalysedPart> parts;
  for (std::size_t i = 0; i < rates_hz.size(); ++i) {
    parts.push_back(part("b" + std::to_string(i), Situation::kNormal, 1, 48000 / rates_hz[i],
                         first_level_db + 0.3 * static_cast<double>(i)));
    parts.back().part.label.feed_bar = 50 + 10.0 * static_cast<double>(i);
  }
  return parts;
}

}  // namespace

TEST_CASE("lint checks a feed series bank by bank, whatever the order of the recordings") {
  std::vector<AnalysedPart> fine = ramp({41, 40.6, 40.2, 39.8, 39.4}, -28);
  std::swap(fine[0], fine[3]);
  lint_series(fine);
  for (const AnalysedPart& p : fine) CHECK(p.warnings.empty());

  std::vector<AnalysedPart> wrong = ramp({41, 40.6, 47, 39.8, 39.4}, -28);
  lint_series(wrong);
  for (const AnalysedPart& p : wrong) CHECK(p.warnings.size() == (&p == &wrong[2] ? 1 : 0));
  CHECK(
      wrong[2].warnings[0] ==
      "47.0 strikes/s in normal at 70 bar, but 40.6 in normal at 60 bar and 39.8 in normal at 80 bar: is its "
      "label right?");
}

TEST_CASE("lint names a bank that was recorded at another gain, and the trim that evens it out") {
  std::vector<AnalysedPart> series = ramp({41, 40.6, 40.2, 39.8, 39.4}, -28);
  series[4].figures.level_db -= 14;
  lint_series(series);
  for (std::size_t i = 0; i < 4; ++i) CHECK(series[i].warnings.empty());
  REQUIRE(series[4].warnings.size() == 1);
  CHECK(series[4].warnings[0] ==
        "13.1 dB softer than the median of its series of 5 banks: another gain? gain_db = 13.1 in "
        "soundset.toml "
        "evens it out");
  // Rattling is loud, and nothing is said of it.
  std::vector<AnalysedPart> rattling = {part("n", Situation::kNormal, 1, 1200, -28),
                                        part("r", Situation::kOpenRattling, 1, 1100, -16)};
  lint_series(rattling);
  CHECK(rattling[1].warnings.empty());
}
