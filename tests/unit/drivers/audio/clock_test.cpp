// The clock that blocks are paced by.
#include "rigsound/audio/clock.hpp"

#include <doctest/doctest.h>
#include <cmath>

#include "drivers/audio/fake_card.hpp"

namespace rigsound::audio {
namespace {

constexpr double kBlock_ns = 64 * 1e9 / 48000;

constexpr int kGroup = 7;  // the most of them in 10 ms

/// How long so many blocks take, ns.
double taken_ns(Pacer& pacer, FakeClock& clock, int blocks) {
  const std::int64_t begin_ns = clock.now;
  for (int k = 0; k < blocks; ++k) pacer.wait();
  return static_cast<double>(clock.now - begin_ns);
}

bool equal(double a_ns, double b_ns) { return std::abs(a_ns - b_ns) < 2; }

TEST_CASE("The real clock never wakes anybody early, and lets who is late go on") {
  MonotonicClock clock;
  const std::int64_t begin_ns = clock.now_ns();
  for (const std::int64_t after_ns : {2'000'000, 1'000'000, 0, -1'000'000'000}) {
    clock.sleep_until_ns(begin_ns + after_ns);
    CHECK(clock.now_ns() >= begin_ns + after_ns);
  }
}

TEST_CASE("Blocks of no whole nanoseconds keep their pace without drift") {
  FakeClock clock;
  const std::int64_t begin_ns = clock.now;
  Pacer pacer(clock, 44100, 64);  // groups of 6
  for (int k = 1; k <= 88200; ++k) {
    pacer.wait();
    if (k % 882 == 0) CHECK(clock.now - begin_ns == k / 882 * std::int64_t{1'280'000'000});
  }
}

TEST_CASE("Blocks that nobody hears go by at their pace in groups of at most 10 ms") {
  FakeClock clock;
  Pacer pacer(clock, 48000, 64);
  CHECK(taken_ns(pacer, clock, kGroup - 1) == 0);
  CHECK(equal(taken_ns(pacer, clock, 1), kGroup * kBlock_ns));
  CHECK(equal(taken_ns(pacer, clock, 749 * kGroup), 749 * kGroup * kBlock_ns));
  CHECK(clock.sleeps == 750);
}

TEST_CASE("A block of 10 ms and more is waited for by itself") {
  FakeClock clock;
  Pacer pacer(clock, 48000, 480);
  CHECK(taken_ns(pacer, clock, 1) == 10e6);
  CHECK(taken_ns(pacer, clock, 1) == 10e6);
}

TEST_CASE("A lead is waited for") {
  FakeClock clock;
  Pacer pacer(clock, 48000, 480);
  pacer.start(250'000'000);
  CHECK(taken_ns(pacer, clock, 1) == 260e6);
}

TEST_CASE("Up to a second is caught up with; after more the pace goes on from where the blocks stand") {
  FakeClock clock;
  Pacer pacer(clock, 48000, 64);
  clock.now += 900'000'000;
  CHECK(equal(taken_ns(pacer, clock, 107 * kGroup), 107 * kGroup * kBlock_ns - 900e6));

  // The last group before the stall began as one: all of its blocks but the first were ahead of their time.
  clock.now += 2'000'000'000;
  CHECK(taken_ns(pacer, clock, kGroup) == 0);
  CHECK(equal(taken_ns(pacer, clock, kGroup), (2 * kGroup - 1) * kBlock_ns));
}

}  // namespace
}  // namespace rigsound::audio
