// Of a long recording a stretch is enough.
#include <doctest/doctest.h>

#include "rigsound/analysis/diesel.hpp"

using namespace rigsound::analysis;

TEST_CASE("a recording up to the longest take is learned from as a whole") {
  for (const TimeTable& rpm : {TimeTable{}, TimeTable{{0, 40}, {800, 2000}}}) {
    const Stretch all = learned_stretch(kLongestTake_s, rpm);
    CHECK(all.start_s == 0);
    CHECK(all.end_s >= kLongestTake_s);
  }
}

TEST_CASE("of a longer one at a steady speed it is the middle") {
  const TimeTable same{{0, 1000, 3600}, {800, 800, 800}};
  for (const TimeTable& rpm : {TimeTable{}, same}) {
    const Stretch middle = learned_stretch(3600, rpm);
    CHECK(middle.start_s == doctest::Approx(1780));
    CHECK(middle.end_s == doctest::Approx(1820));
  }
}

TEST_CASE("of a longer run-up it is where the speed moves most") {
  TimeTable rpm;
  for (int s = 0; s <= 3600; ++s) {
    rpm.time_s.push_back(s);
    rpm.value.push_back(s < 3000 ? 800 : s < 3030 ? 800 + 40 * (s - 3000) : s < 3040 ? 2000 : 900);
  }
  const Stretch widest = learned_stretch(3600, rpm);
  CHECK(widest.start_s <= 3000);
  CHECK(widest.end_s > 3030);
  CHECK(widest.end_s - widest.start_s == doctest::Approx(kLongestTake_s));
  const TimeTable sparse{{0, 3600}, {800, 2000}};  // no row in most windows
  CHECK(learned_stretch(3600, sparse).end_s <= 3600);
}
