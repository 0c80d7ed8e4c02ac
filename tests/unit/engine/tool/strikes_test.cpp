// What a blow does to the steel: its pulse, its bounces, and the hand that damps the bar.
#include "tool/strikes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tool/contact.hpp"

using namespace rigsound;
using namespace rigsound::tool;

namespace {

Strike plain_strike() {
  Strike strike;
  strike.amplitude_variation = 0;
  strike.bounces = 0;
  strike.slope_variation = 0;
  return strike;
}

}  // namespace

TEST_CASE("a blow is a Hann pulse that begins between samples") {
  Strike strike = plain_strike();
  Strikes strikes(strike, 48000, 1, 0);
  const Impact blow{29.25, 2, 0};
  double x[2 * kChunk];
  CHECK(strikes.process({&blow, 1}, 2400, x));
  CHECK(strikes.process({}, 2400, x + kChunk));
  const double width = strike.width_s * 48000;
  for (int n = 0; n < 2 * kChunk; ++n) {
    const double t = n - 29.25;
    const double pulse = t >= 0 && t < width ? 1 - std::cos(2 * M_PI * t / width) : 0;
    CHECK(x[n] == doctest::Approx(pulse).epsilon(1e-12));
  }
  CHECK_FALSE(strikes.process({}, 2400, x));
}

TEST_CASE("bounces follow one another by 5 to 10 % of the period, each weaker than the last") {
  Strike strike;
  Strikes strikes(strike, 48000, 5, 0);
  const double period = 4000;
  double lowest = 1, highest = 0, first = 0;
  int touches = 0, amplitudes_in_range = 0;
  for (std::uint64_t blow = 0; blow < 300; ++blow) {
    double x[kChunk], last = 0;
    for (int chunk = 0; chunk < 125; ++chunk) {
      const Impact impact{0, 1, blow};
      strikes.process({&impact, chunk == 0}, period, x);
      for (const Touch& touch : strikes) {
        const double at = chunk * kChunk + touch.at;
        if (at > 0)
          lowest = std::min(lowest, (at - last) / period), highest = std::max(highest, (at - last) / period);
        last = at;
        ++touches;
        CHECK(std::fabs(touch.slope - 1) <= strike.slope_variation);
      }
      if (chunk == 0) first = *std::max_element(x, x + kChunk);
    }
    amplitudes_in_range += first > 0.78 && first <= 1.2;
  }
  CHECK(touches == 300 * (1 + strike.bounces));
  CHECK(lowest >= 0.05 - 1 / period);
  CHECK(lowest < 0.055);
  CHECK(highest <= 0.10 + 1 / period);
  CHECK(highest > 0.095);
  CHECK(amplitudes_in_range == 300);
}

TEST_CASE("a bounce has 0.3 to 0.7 of the amplitude of what was before it, and all of that range comes") {
  Strike strike;
  strike.slope_variation = 0;
  Strikes strikes(strike, 48000, 5, 0);
  double lowest = 1, highest = 0;
  for (std::uint64_t blow = 0; blow < 300; ++blow) {
    std::vector<double> x(125 * kChunk);
    std::vector<std::size_t> at;
    for (std::size_t chunk = 0; chunk < 125; ++chunk) {
      const Impact impact{0, 1, blow};
      strikes.process({&impact, chunk == 0}, 4000, &x[chunk * kChunk]);
      for (const Touch& touch : strikes) at.push_back(chunk * kChunk + static_cast<std::size_t>(touch.at));
    }
    // 10.9 samples wide: between the samples next to its top the pulse falls by 2 % at most.
    const auto top = [&](std::size_t i) {
      return *std::max_element(x.begin() + static_cast<std::ptrdiff_t>(at[i]),
                               x.begin() + static_cast<std::ptrdiff_t>(at[i]) + 11);
    };
    REQUIRE(at.size() == 4);
    for (std::size_t i = 1; i < at.size(); ++i)
      lowest = std::min(lowest, top(i) / top(i - 1)), highest = std::max(highest, top(i) / top(i - 1));
  }
  CHECK(lowest > 0.3 * 0.97);
  CHECK(lowest < 0.31);
  CHECK(highest < 0.7 * 1.03);
  CHECK(highest > 0.69);
}

TEST_CASE("touches come in order, and of two at one sample the later blow's is what is felt") {
  Strike strike = plain_strike();
  strike.slope_variation = 0.3;
  const auto slope_of = [&](std::uint64_t index) {
    Strikes alone(strike, 48000, 1, 0);
    const Impact blow{9, 1, index};
    double x[kChunk];
    alone.process({&blow, 1}, 2400, x);
    return alone.begin()->slope;
  };
  Strikes strikes(strike, 48000, 1, 0);
  const Impact blows[] = {{9, 1, 0}, {30.5, 1, 1}, {3, 1, 2}, {8.5, 1, 3}};
  double x[kChunk];
  strikes.process({blows, 4}, 2400, x);
  REQUIRE(strikes.end() - strikes.begin() == 3);
  const Touch* const touch = strikes.begin();
  CHECK(touch[0].at == 3);
  CHECK(touch[0].slope == slope_of(2));
  CHECK(touch[1].at == 9);
  CHECK(touch[1].slope == slope_of(3));
  CHECK(touch[2].at == 31);
  CHECK(touch[2].slope == slope_of(1));
}

TEST_CASE("k_T falls from where it is at each touch and rises after, never faster than its slopes") {
  LoopDesign loop;
  loop.reflection_min = 0.83, loop.reflection_max = 0.89;
  Strike strike = plain_strike();
  strike.bounces = 4;
  Strikes strikes(strike, 48000, 1, 0);
  Contact contact(loop, strike, 48000);
  double before = 0.89, lowest = 1;
  for (int chunk = 0; chunk < 400; ++chunk) {
    const Impact blow{7.5, 1, static_cast<std::uint64_t>(chunk)};
    double x[kChunk], k_T[kChunk];
    strikes.process({&blow, chunk % 80 == 0}, 2560, x);
    contact.process(strikes, k_T);
    for (const double k : k_T) {
      CHECK(k - before <= 0.06 / (0.010 * 48000) + 1e-12);
      CHECK(before - k <= 0.06 / (0.002 * 48000) + 1e-12);
      CHECK(k >= 0.83);
      CHECK(k <= 0.89);
      before = k;
      lowest = std::min(lowest, k);
    }
  }
  CHECK(lowest == 0.83);
}
