// No block's level is lost between two scrapes, and none counts twice.
#include "levels.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

/// A window of two blocks with these levels of the output, and the third of them of boom 1's drill.
LevelWindow window(std::uint32_t number, float peak, float rms) {
  EngineView view;
  view.boom[1].drill = {peak / 3, rms / 3};
  LevelWindow w;
  w.number = number;
  w.add({peak / 2, rms, 0.5F, 0}, view);
  w.add({peak, rms, 0.75F, 0}, view);
  return w;
}

}  // namespace

TEST_CASE("a window holds the peak, the rms and the lowest limiter gain of its blocks") {
  const LevelWindow w = window(1, 0.8F, 0.2F);
  CHECK(w.blocks == 2);
  CHECK(w.output.peak == 0.8F);
  CHECK(w.output.rms(w.blocks) == doctest::Approx(0.2));
  CHECK(w.drill[1].rms(w.blocks) == doctest::Approx(0.2 / 3));
  CHECK(w.drill[0].peak == 0);
  CHECK(w.limiter_gain == 0.5F);
}

TEST_CASE("a scrape holds every window since the one before, however many, and each once") {
  Levels levels;
  levels.take(window(1, 0.9F, 0.3F));
  for (std::uint32_t i = 2; i <= 20; ++i) {
    levels.take(window(i, 0.1F, 0.1F));
    levels.take(window(i, 0.1F, 0.1F));  // polled again before the next was closed
  }
  const LevelWindow first = levels.since_scrape();
  CHECK(first.blocks == 40);
  CHECK(first.output.peak == 0.9F);
  CHECK(first.output.rms(first.blocks) == doctest::Approx(std::sqrt((0.09 + 19 * 0.01) / 20)));
  levels.take(window(21, 0.2F, 0.1F));
  CHECK(levels.since_scrape().output.peak == 0.2F);
  CHECK(levels.since_scrape().output.peak == 0.2F);  // nothing new: the last moments
}

TEST_CASE("recent levels forget") {
  Levels levels;
  levels.take(window(1, 0.9F, 0.3F));
  CHECK(levels.recent().output.peak == 0.9F);
  for (std::uint32_t i = 2; i <= 5; ++i) levels.take(window(i, 0.1F, 0.1F));
  CHECK(levels.recent().output.peak == 0.1F);
  CHECK(levels.taken() == 5);
}
