// Onsets of two machines, divided by their rhythms, against who struck them.
#include "clicks/onset_owners.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace {

constexpr std::array<GapFigures, 2> kTwoRates{GapFigures{2285, 0.04}, GapFigures{1411, 0.04}};

/// Onsets with the machine that struck each, ascending.
using Struck = std::vector<std::pair<int, int>>;

/// `periods` of one machine, its gaps normal; every `missing`-th impact is not heard.
void strike(TestNoise& draw, int machine, int periods, int missing, Struck& struck) {
  const GapFigures& gaps = kTwoRates[machine];
  double time = gaps.period * draw.uniform();
  for (int i = 1; i <= periods; ++i) {
    if (missing == 0 || i % missing != 0) struck.emplace_back(static_cast<int>(time), machine);
    time += gaps.period * (1 + gaps.scatter * draw.normal());
  }
  std::sort(struck.begin(), struck.end());
}

bool strikes_near(const Struck& struck, int machine, int onset) {
  constexpr int kSame = 96;  // samples: nobody hears two impacts within 2 ms apart
  return std::any_of(struck.begin(), struck.end(), [&](const auto& s) {
    return s.second == machine && std::abs(s.first - onset) <= kSame;
  });
}

/// Share of the onsets whose owner struck then.
double share_right(const Struck& struck) {
  std::vector<int> onsets;
  for (const auto& [onset, machine] : struck) onsets.push_back(onset);
  const std::vector<int> owner = owners(onsets, kTwoRates);
  int right = 0;
  for (std::size_t i = 0; i < onsets.size(); ++i) right += strikes_near(struck, owner[i], onsets[i]);
  return right / static_cast<double>(struck.size());
}

/// Over ten draws of both machines, every `missing`-th impact of each not heard.
double mean_share_right(int missing) {
  double right = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    TestNoise draw(seed);
    Struck struck;
    strike(draw, 0, 80, missing, struck);
    strike(draw, 1, 130, missing, struck);
    right += share_right(struck) / 10;
  }
  return right;
}

}  // namespace

TEST_CASE("gap figures are those of the drawn gaps, whatever a few of them are") {
  TestNoise draw(1);
  std::vector<int> onsets{0};
  for (int i = 0; i < 400; ++i)
    onsets.push_back(onsets.back() + static_cast<int>(2000 * (1 + 0.05 * draw.normal())) +
                     (i % 20 == 0 ? 2000 : 0));
  const GapFigures figures = gap_figures(onsets);
  CHECK(figures.period == doctest::Approx(2000).epsilon(0.01));
  CHECK(figures.scatter == doctest::Approx(0.05).epsilon(0.15));
  CHECK(gap_figures({0, 100, 200, 300}).scatter == 0.02);
}

TEST_CASE("of two machines that strike at rates of their own every onset but a few goes to who struck it") {
  CHECK(mean_share_right(0) > 0.97);
}

TEST_CASE("one impact in twelve of each may be missed") { CHECK(mean_share_right(12) > 0.97); }

TEST_CASE("an onset in no rhythm is nobody's") {
  Struck struck;
  for (int i = 0; i < 30; ++i) struck.emplace_back(2285 * i, 0);
  for (int i = 0; i < 48; ++i) struck.emplace_back(700 + 1411 * i, 1);
  for (const int stray : {2285 * 7 + 1080, 2285 * 19 + 900}) struck.emplace_back(stray, kNobody);
  std::sort(struck.begin(), struck.end());
  CHECK(share_right(struck) == 1);
}

TEST_CASE("a pause of one machine is no reason to give it the other's impacts") {
  Struck struck;
  for (int i = 0; i < 40; ++i)
    if (i < 12 || i > 27) struck.emplace_back(2285 * i, 0);
  for (int i = 0; i < 64; ++i) struck.emplace_back(700 + 1411 * i, 1);
  std::sort(struck.begin(), struck.end());
  CHECK(share_right(struck) == 1);
}

TEST_CASE("no onsets have no owners, and one of a single machine is its own") {
  CHECK(owners({}, kTwoRates).empty());
  Struck alone;
  for (int i = 0; i < 20; ++i) alone.emplace_back(1411 * i, 1);
  CHECK(share_right(alone) == 1);
}
