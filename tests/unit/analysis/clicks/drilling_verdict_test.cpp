// The drilling test: what it takes for an answer, figure by figure.
#include "clicks/drilling_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "analysis/noise.hpp"
#include "clicks/candidates.hpp"
#include "rigsound/analysis/chain.hpp"
#include "spectrum/power_spectrogram.hpp"

using namespace rigsound::analysis;

namespace {

/// A drill as recordings show it: 30 sharp, regular, similar blows a second that explain what changes.
DrillingEvidence drill() {
  DrillingEvidence e;
  for (int i = 0; i < 60; ++i) e.clicks.P.push_back(1600 * i);
  e.clicks.mean_gap_samples = 1600;
  e.clicks.envelope.attack_samples = 50;
  e.total = 150;
  e.surplus = 120;
  e.fast_total = 1;
  e.irregularity = 0.04;
  e.jitter = 0.04;
  e.likeness = {0.16, 1.2, 0.02};
  e.background_alone = kNoiseDivergence + 0.3;
  e.with_clicks = kNoiseDivergence + 0.03;
  e.left_over = kNoiseDivergence + 0.02;
  return e;
}

DrillingEvidence after(const std::function<void(DrillingEvidence&)>& change) {
  DrillingEvidence e = drill();
  change(e);
  return e;
}

double probability(const std::function<void(DrillingEvidence&)>& change) {
  return drilling_probability(after(change));
}

bool refused(const std::function<void(DrillingEvidence&)>& change) {
  return probability(change) < kDrillingProbability;
}

/// What is said against it, which must be refused.
std::string reason_after(const std::function<void(DrillingEvidence&)>& change) {
  CHECK(refused(change));
  return objections_to(after(change));
}

}  // namespace

TEST_CASE("a drill is a drill, from 8 to 80 blows a second") {
  CHECK(!refused([](DrillingEvidence&) {}));
  CHECK(!refused([](DrillingEvidence& e) { e.clicks.mean_gap_samples = 48000 / 8.2; }));
  CHECK(!refused([](DrillingEvidence& e) { e.clicks.mean_gap_samples = 48000 / 80.0; }));
}

TEST_CASE("each figure alone is reason enough when it is far out") {
  CHECK(reason_after([](DrillingEvidence& e) { e.clicks.P.resize(3); }) == "3 clicks, expected 4 or more");
  CHECK(reason_after([](DrillingEvidence& e) {
          e.clicks.envelope.attack_samples = 480, e.likeness.rise = 1;
        }) == "it swells in 10.0 ms instead of striking");
  CHECK(reason_after([](DrillingEvidence& e) { e.surplus = 6; }) == "its clicks are 0.1 above chance");
  CHECK(reason_after([](DrillingEvidence& e) { e.fast_total = 180; }) ==
        "it pulses faster than 130 Hz, like a voice or a tone");
  CHECK(reason_after([](DrillingEvidence& e) { e.likeness.dispersion = 0.5; }) ==
        "its clicks do not resemble one another");
  CHECK(reason_after([](DrillingEvidence& e) { e.likeness.rise = -0.5; }) ==
        "its bands do not rise together");
  CHECK(reason_after([](DrillingEvidence& e) { e.likeness.rhythm = 0.7; }) == "its clicks follow a rhythm");
  CHECK(reason_after([](DrillingEvidence& e) { e.strength_rhythm = 12; }) == "its clicks follow a rhythm");
  CHECK(reason_after([](DrillingEvidence& e) { e.jitter = std::log(1.5); }) == "its gaps differ by 50 %");
  CHECK(reason_after([](DrillingEvidence& e) { e.repetition = 0.95, e.likeness.rise = 0.7; }) ==
        "its waveform comes again and again, like that of a voice, an engine or a creak");
  CHECK(reason_after([](DrillingEvidence& e) { e.left_over = kNoiseDivergence + 0.55; }) ==
        "more than noise is left beside its clicks");
}

TEST_CASE("what is left beside clicks that are all one sound is of their own form") {
  CHECK(!refused(
      [](DrillingEvidence& e) { e.left_over = kNoiseDivergence + 3, e.likeness.dispersion = 0.001; }));
}

TEST_CASE("clicks near chance are a drill's where noise hides them, not where something else is heard") {
  const auto near_chance = [](DrillingEvidence& e) {
    e.surplus = 0.5 * static_cast<double>(e.clicks.P.size());
  };
  CHECK(!refused(near_chance));
  CHECK(refused([&](DrillingEvidence& e) { near_chance(e), e.left_over = kNoiseDivergence + 0.15; }));
  CHECK(!refused([&](DrillingEvidence& e) { e.left_over = kNoiseDivergence + 0.15; }));
}

TEST_CASE("a waveform that comes again belongs to clicks that resemble one another") {
  const auto again = [](DrillingEvidence& e) { e.repetition = 0.65, e.likeness.rise = 1.7; };
  const auto unlike = [](DrillingEvidence& e) { e.likeness.dispersion = 0.33; };
  CHECK(!refused(again));
  CHECK(probability(again) == doctest::Approx(drilling_probability(drill())));
  CHECK(probability(unlike) - probability([&](DrillingEvidence& e) { again(e), unlike(e); }) > 0.3);
}

TEST_CASE("what a codec or noise hides is a doubt, and with another one reason enough") {
  const auto hidden = [](DrillingEvidence& e) { e.with_clicks = e.background_alone - 0.06; };
  CHECK(!refused(hidden));
  CHECK(probability(hidden) < drilling_probability(drill()));
  CHECK(objections_to(after(hidden)) == "a repeated click explains 20 % of its changes");
  CHECK(refused(
      [&](DrillingEvidence& e) { hidden(e), e.surplus = 0.5 * static_cast<double>(e.clicks.P.size()); }));
}

TEST_CASE(
    "a few clicks as quick as a drill's may fall like that by chance, a few slow ones are all there are") {
  const auto few = [](DrillingEvidence& e) {
    e.clicks.P.resize(20), e.surplus = 24, e.clicks.mean_gap_samples = 4800;
  };
  const auto fewer = [&](DrillingEvidence& e) { few(e), e.clicks.P.resize(7), e.surplus = 8; };
  CHECK(!refused(few));
  CHECK(refused(fewer));
  CHECK(!refused([&](DrillingEvidence& e) { fewer(e), e.clicks.mean_gap_samples = 48000 / 3.5; }));
}

TEST_CASE("jitter is what a gap differs from those around it by, however its rate glides") {
  ClickTrain clicks;
  for (double t = 0, gap = 1000; t < 96000; t += gap, gap *= 1.01) clicks.P.push_back(static_cast<int>(t));
  CHECK(irregularity(clicks) > 0.1);
  CHECK(jitter(clicks) < 0.002);
  clicks.P.clear();
  for (int i = 0; i < 60; ++i) clicks.P.push_back(1000 * i + (i % 3 == 1 ? 100 : 0));  // gaps 1100, 900, 1000
  CHECK(jitter(clicks) == doctest::Approx(irregularity(clicks)));
  CHECK(jitter(clicks) == doctest::Approx(std::log(1.1)));
}

TEST_CASE("a slow breaker is a drill, if a less likely one") {
  const auto slow = [](DrillingEvidence& e) { e.clicks.mean_gap_samples = 48000 / 3.4; };
  CHECK(!refused(slow));
  CHECK(probability(slow) < drilling_probability(drill()));
  CHECK(objections_to(after(slow)) == "3.4 clicks a second are slow");
}

TEST_CASE("a steep rise or a long period excuses a long attack") {
  CHECK(refused([](DrillingEvidence& e) { e.clicks.envelope.attack_samples = 350, e.likeness.rise = 1; }));
  CHECK(!refused([](DrillingEvidence& e) { e.clicks.envelope.attack_samples = 350, e.likeness.rise = 2.9; }));
  CHECK(!refused(
      [](DrillingEvidence& e) { e.clicks.envelope.attack_samples = 350, e.clicks.mean_gap_samples = 3500; }));
}

TEST_CASE("the attack of rough clicks breaks no promise, whatever else speaks against them does") {
  const auto dull = [](DrillingEvidence& e) { e.likeness.rise = 0.1; };
  const auto swelling = [&](DrillingEvidence& e) { dull(e), e.clicks.envelope.attack_samples = 480; };
  CHECK(refused(swelling));
  CHECK(drilling_promise(after(swelling)) == doctest::Approx(probability(dull)));
  CHECK(drilling_promise(after(dull)) == doctest::Approx(probability(dull)));
  CHECK(drilling_promise(after([](DrillingEvidence& e) { e.clicks.P.resize(3); })) == 0);
}

TEST_CASE("a waveform that repeats speaks against what hardly rises and what slips at uneven times") {
  const auto copies = [](DrillingEvidence& e) {
    e.repetition = 0.99, e.irregularity = 0, e.likeness.rise = 2.5;
  };
  CHECK(!refused(copies));
  CHECK(refused([&](DrillingEvidence& e) { copies(e), e.likeness.rise = 0.9; }));
  CHECK(refused([&](DrillingEvidence& e) { copies(e), e.irregularity = 0.09; }));
  CHECK(!refused(
      [](DrillingEvidence& e) { e.repetition = 0.6, e.likeness.rise = 0.9, e.irregularity = 0.09; }));
}

TEST_CASE("pulses that are a fast drifter's own clicks are not held against it") {
  TestNoise draw(1);
  const auto pulsing_at = [&](double hz) {
    Eigen::ArrayXd y = 0.05 * draw.normals(96000);
    ClickTrain clicks;
    for (double t = 400; t < 95000; t += 48000 / hz) {
      clicks.P.push_back(static_cast<int>(t));
      for (int n = 0; n < 200; ++n) y(static_cast<long>(t) + n) += std::exp(-n / 60.0) * draw.normal();
    }
    clicks.mean_gap_samples = 48000 / hz;
    return std::pair{find_candidates(y), clicks};
  };
  const auto [fast, of_fast] = pulsing_at(118);
  CHECK(fast_total(fast, of_fast) == 0);
  ClickTrain every_other = of_fast;
  every_other.mean_gap_samples *= 2;
  CHECK(fast_total(fast, every_other) > 100);
  const auto [voice, of_voice] = pulsing_at(150);
  CHECK(fast_total(voice, of_voice) > 100);
}

TEST_CASE("objections add up, and the reason names those that count") {
  const auto alike = [](DrillingEvidence& e) { e.likeness.dispersion = 0.35; };
  const auto regular = [](DrillingEvidence& e) { e.jitter = 0.16; };
  const auto both = [&](DrillingEvidence& e) { alike(e), regular(e); };
  CHECK(probability(both) < probability(alike));
  CHECK(probability(both) < probability(regular));
  const std::string reason = objections_to(after(both));
  CHECK(reason.find("its clicks do not resemble one another") != std::string::npos);
  CHECK(reason.find("its gaps differ by 17 %") != std::string::npos);
}

TEST_CASE("the probability is logistic in the weights, and a figure far out says no more than kMostWeight") {
  const DrillingEvidence e =
      after([](DrillingEvidence& d) { d.likeness.rhythm = 0.2, d.likeness.rise = 0.3; });
  double logit = kBias;
  const auto weights = objection_weights(e);
  for (std::size_t i = 0; i < kObjections; ++i) {
    CHECK(weights[i] >= 0);
    CHECK(kCoefficients[i] >= 0);
    logit -= kCoefficients[i] * weights[i];
  }
  CHECK(drilling_probability(e) == doctest::Approx(1 / (1 + std::exp(-logit))));
  const auto far = objection_weights(after([](DrillingEvidence& d) { d.likeness.rhythm = 5; }));
  CHECK(*std::max_element(far.begin(), far.end()) == kMostWeight);
}
