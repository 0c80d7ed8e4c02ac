// Recorded starts and stops, and when the running engine comes in.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/diesel/bare_diesel.hpp"
#include "engine/diesel/played_diesel.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

TEST_CASE("recorded start and stop play once each") {
  DieselModel model = bare_diesel(800);
  model.start.assign(24000, 0.25F);
  model.stop.assign(12000, -0.125F);
  DieselLayer layer({model}, kRate, 1, 800);
  const auto sum = [](const std::vector<double>& x) {
    double s = 0;
    for (const double v : x) s += v;
    return s;
  };
  CHECK(sum(play(layer, {800, 0, 0}, 3)) == doctest::Approx(6000));
  CHECK(sum(play(layer, {0, 0, 0}, 3)) == doctest::Approx(-1500));
}

TEST_CASE("the running engine comes in 0.3 s before the end of a recorded start, and not before") {
  DieselModel model = bare_diesel(800);
  model.points[0].orders.assign(12, {0, 0});
  model.points[0].orders[11] = {0.1F, 0.0F};  // 80 Hz
  model.start.assign(48000, 0.0F);
  DieselLayer layer({model}, kRate, 1, 800);
  const std::vector<double> x = play(layer, {800, 0, 0}, 2);
  std::size_t begins = 0;
  while (begins < x.size() && x[begins] == 0) ++begins;
  CHECK(static_cast<double>(begins) / kRate >= 0.7);
  CHECK(static_cast<double>(begins) / kRate < 0.8);  // the crank turns after a moment
  // Gained with 40 ms.
  const auto amplitude = [&](double from_s) {
    double most = 0;
    for (auto n = static_cast<std::size_t>(from_s * kRate);
         n < static_cast<std::size_t>((from_s + 0.0125) * kRate); ++n)
      most = std::max(most, std::fabs(x[n]));
    return most;
  };
  const double first_s = static_cast<double>(begins) / kRate;
  CHECK(amplitude(first_s + 0.0275) ==
        doctest::Approx(0.1 * (1 - std::exp(-0.04 / 0.04))).scale(0).epsilon(0.1));
  CHECK(amplitude(first_s + 0.3) == doctest::Approx(0.1).scale(0).epsilon(0.01));
}

TEST_CASE("a recorded start sounds alike at every rate, without what lies above half of it") {
  const auto energy_s = [](double hz, double rate) {
    DieselModel model = bare_diesel(800);
    for (int n = 0; n < 24000; ++n)
      model.start.push_back(static_cast<float>(0.25 * std::sin(2 * M_PI * hz * n / model.sample_rate)));
    DieselLayer layer({model}, rate, 1, 800);
    const std::vector<double> x = play(layer, {800, 0, 0}, 3);
    return power(x) * static_cast<double>(x.size()) / rate;
  };
  const double whole = 0.5 * 0.25 * 0.25 * 0.5;
  for (const double rate : {32000.0, 48000.0, 96000.0})
    CHECK(energy_s(5000, rate) == doctest::Approx(whole).scale(0).epsilon(0.005));
  CHECK(energy_s(20000, 32000) < 1e-3 * whole);
}

TEST_CASE("a one-shot that is overtaken fades away") {
  DieselModel model = bare_diesel(800);
  model.start.assign(48000, 0.25F);
  model.stop.assign(48000, -0.125F);
  DieselLayer layer({model}, kRate, 1, 800);
  const auto steps_of = [](const std::vector<double>& x) {
    double worst = 0;
    for (std::size_t n = 1; n < x.size(); ++n) worst = std::max(worst, std::fabs(x[n] - x[n - 1]));
    return worst;
  };
  play(layer, {100, 0, 0}, 0.3);  // cranked, and it does not catch
  const std::vector<double> gave_up = play(layer, {0, 0, 0}, 0.5);
  CHECK(steps_of(gave_up) < 0.001);
  CHECK(gave_up.back() == 0);
  play(layer, {800, 0, 0}, 3);
  play(layer, {0, 0, 0}, 0.4);  // dying, and started again
  const std::vector<double> again = play(layer, {800, 0, 0}, 0.5);
  CHECK(again.back() == doctest::Approx(0.25));
  CHECK(steps_of(again) < 0.3);  // the start may begin as it likes, the stop's end is smooth
}
