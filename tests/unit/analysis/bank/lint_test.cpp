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
  p.figures = {60, 1, 1, 48000 / T_0, level_db, 10, 0.05, 0.05, 0.3, 2};
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
  CHECK(warns(with([](AnalysedPart& p) { p.figures.rate_hz = 95; }), "rate out of range"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.segments = 3; }), "1 of 3 segments"));
}

TEST_CASE("lint finds the bank that is out of order in its series") {
  std::vector<AnalysedPart> rods = {
      part("r1", Situation::kNormal, 1, 1200, -20), part("r3", Situation::kNormal, 3, 1240, -21),
      part("r5", Situation::kNormal, 5, 1500, -22), part("r7", Situation::kNormal, 7, 1320, -23)};
  lint_series(rods);
  CHECK(rods[0].warnings.empty());
  CHECK(rods[1].warnings.empty());
  CHECK(warns(rods[2].warnings, "T0"));
  CHECK_FALSE(warns(rods[2].warnings, "level"));
  CHECK(rods[3].warnings.empty());

  std::vector<AnalysedPart> feed = {part("u", Situation::kUnderfeed, 1, 1300, -15),
                                    part("n", Situation::kNormal, 1, 1200, -20),
                                    part("o", Situation::kOverfeed, 1, 1000, -22)};
  lint_series(feed);
  CHECK(warns(feed[0].warnings, "level"));
  CHECK(feed[1].warnings.empty());
  CHECK(warns(feed[2].warnings, "T0"));
}
