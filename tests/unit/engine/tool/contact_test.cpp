// k_T sample by sample: falls straight from where it is, stops at its least, recovers straight.
#include "tool/contact.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace rigsound;
using namespace rigsound::tool;

namespace {

constexpr double kContactRate = 48000, kUntouched = -7;

LoopDesign loop_between(double least, double most) {
  LoopDesign loop;
  loop.reflection_min = least, loop.reflection_max = most;
  return loop;
}

/// As the paper's section 3.4 says it, one sample after another.
struct PaperContact {
  double least, most, fall, rise;
  double k = most, slope = 1;
  bool falling = false;

  double next() {
    if (falling) {
      k -= slope * fall;
      if (k <= least) k = least, falling = false;
    } else if (k < most) {
      k = k + slope * rise < most ? k + slope * rise : most;
    }
    return k;
  }
};

}  // namespace

TEST_CASE("k_T is the paper's ramps, whatever chunk they begin, meet and end in") {
  Strike strike;
  strike.amplitude_variation = strike.slope_variation = 0;
  strike.bounces = 0;
  const double least = 0.61, most = 0.9713;
  for (const double fall_s : {0.0001, 0.00071, 0.0031})
    for (const double rise_s : {0.0003, 0.0053}) {
      strike.fall_s = fall_s, strike.rise_s = rise_s;
      Contact contact(loop_between(least, most), strike, kContactRate);
      Strikes strikes(strike, kContactRate, 1, 0);
      PaperContact reference{least, most, (most - least) / (fall_s * kContactRate),
                             (most - least) / (rise_s * kContactRate)};
      CHECK(contact.rests());
      for (int chunk = 0; chunk < 200; ++chunk) {
        double pulses[kChunk];
        std::vector<double> k_T(kChunk + 1, kUntouched);
        const Impact blow{static_cast<double>(chunk * 7 % 32), 1, static_cast<std::uint64_t>(chunk)};
        const bool strikes_now = chunk % 9 == 2 || chunk % 9 == 3;  // the second where k_T is under way
        strikes.process({&blow, strikes_now ? 1 : 0}, 4000, pulses);
        contact.process(strikes, k_T.data());
        const Touch* touch = strikes.begin();
        for (int n = 0; n < kChunk; ++n) {
          if (touch != strikes.end() && touch->at == n) {
            reference.falling = true, reference.slope = touch->slope;
            ++touch;
          }
          const double expected = reference.next();
          REQUIRE(k_T[n] == doctest::Approx(expected).epsilon(1e-9));
        }
        CHECK(k_T[kChunk] == kUntouched);
        CHECK(contact.rests() == (!reference.falling && reference.k == most));
      }
    }
}

TEST_CASE("where the hand does not damp, k_T stays") {
  Strike strike;
  Contact contact(loop_between(0.9, 0.9), strike, kContactRate);
  Strikes strikes(strike, kContactRate, 1, 0);
  const Impact blow{3, 1, 0};
  double pulses[kChunk], k_T[kChunk];
  strikes.process({&blow, 1}, 4000, pulses);
  contact.process(strikes, k_T);
  for (const double k : k_T) CHECK(k == 0.9);
  CHECK(contact.rests());
}
