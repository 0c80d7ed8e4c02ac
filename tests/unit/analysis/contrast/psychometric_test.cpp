// A listener whose curve is known is found again.
#include "contrast/psychometric.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "rigsound/dsp/random.hpp"

using namespace rigsound::analysis;

namespace {

/// Trials every `step_bar` up to 60 bar of a listener with that curve.
std::vector<Trial> listened(const Psychometric& curve, double step_bar, int of, std::uint64_t seed) {
  std::vector<Trial> trials;
  const rigsound::dsp::RandomField random(seed, 77);
  std::uint64_t index = 0;
  for (double away = step_bar; away <= 60; away += step_bar) {
    Trial trial{away, 0, of};
    for (int i = 0; i < of; ++i) trial.right += random.uniform(index++, 0) < curve.right(away) ? 1 : 0;
    trials.push_back(trial);
  }
  return trials;
}

}  // namespace

TEST_CASE("a curve says half at no distance and turns into its inverse") {
  const Psychometric curve{20, 2.5};
  CHECK(curve.right(0) == doctest::Approx(0.5));
  CHECK(curve.right(1e4) == doctest::Approx(0.99));
  for (const double share : {0.55, 0.75, 0.9})
    CHECK(curve.right(curve.away_bar(share)) == doctest::Approx(share));
}

TEST_CASE("scale and slope of a known listener are recovered") {
  for (const Psychometric& truth : {Psychometric{20, 2}, Psychometric{30, 4}, Psychometric{10, 1}}) {
    CAPTURE(truth.scale_bar);
    const Psychometric found = fit_psychometric(listened(truth, 4, 2000, 1));
    CHECK(found.scale_bar == doctest::Approx(truth.scale_bar).epsilon(0.05));
    CHECK(found.slope == doctest::Approx(truth.slope).epsilon(0.12));
  }
}

TEST_CASE("the interval holds the true threshold about as often as it says, and shrinks with more trials") {
  const Psychometric truth{25, 2};
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Reach reach = reach_of(listened(truth, 5, 160, seed), seed);
    const double wanted = truth.away_bar(kToldRight);
    CHECK(reach.found);
    if (reach.low_bar <= wanted && wanted <= reach.high_bar) ++held;
  }
  CHECK(held >= 34);  // 38 expected
  const Reach few = reach_of(listened(truth, 5, 40, 1), 1), many = reach_of(listened(truth, 5, 640, 1), 1);
  CHECK(many.high_bar - many.low_bar < 0.5 * (few.high_bar - few.low_bar));
}

TEST_CASE("who guesses at every feed reaches nothing") {
  CHECK_FALSE(reach_of(listened({1e6, 2}, 5, 160, 3), 3).found);
  CHECK_FALSE(reach_of({}, 3).found);
}
