// The clock that blocks are paced by.
#include "rigsound/audio/clock.hpp"

#include <doctest/doctest.h>

#include "drivers/audio/fake_card.hpp"

using namespace rigsound::audio;

TEST_CASE("The real clock never wakes anybody early, and lets who is late go on") {
  MonotonicClock clock;
  const std::int64_t begin = clock.now_ns();
  for (const std::int64_t after_ns : {2'000'000, 1'000'000, 0, -1'000'000'000}) {
    clock.sleep_until_ns(begin + after_ns);
    CHECK(clock.now_ns() >= begin + after_ns);
  }
}

TEST_CASE("Block k is due k block lengths after the first, without drift") {
  FakeClock clock;
  const std::int64_t begin = clock.now;
  Pacer pacer(clock, 44100, 64);
  for (int k = 1; k <= 44100; ++k) {
    pacer.wait();
    if (k % 441 == 0) CHECK(clock.now - begin == k / 441 * std::int64_t{640'000'000});
  }
}

TEST_CASE("Who is late by up to a second catches up, by more begins anew, and a lead is waited for") {
  FakeClock clock;
  Pacer pacer(clock, 48000, 48);  // 1 ms
  std::int64_t begin = clock.now;
  clock.now += 1'001'000'000;
  pacer.wait();  // due after 1 ms
  CHECK(clock.now == begin + 1'001'000'000);
  for (int k = 2; k <= 1002; ++k) pacer.wait();
  CHECK(clock.now == begin + 1'002'000'000);
  clock.now += 1'500'000'000;
  begin = clock.now;
  pacer.wait();
  CHECK(clock.now == begin);
  pacer.wait();
  CHECK(clock.now == begin + 1'000'000);
  begin = clock.now;
  pacer.start(250'000'000);
  pacer.wait();
  CHECK(clock.now == begin + 251'000'000);
}
