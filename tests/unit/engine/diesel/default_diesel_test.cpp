// The built-in diesel: six cylinders, four strokes, a body of its own.
#include "rigsound/default_diesel.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "diesel/source_point.hpp"

using namespace rigsound;

namespace {

constexpr double kPulse = 11.0 / 720;  // cycles

/// Order k with the body and the shape of a pulse taken off: what six strengths at even distances leave.
std::complex<double> strengths(const DieselModel& m, const DieselPoint& p, int k) {
  const std::complex<double> shape = std::pow(std::complex<double>(1, 2 * M_PI * k * kPulse), -2.0);
  const double body = diesel::body_db(m.body, k * cycles_per_second(p.rpm));
  return std::complex<double>(p.orders[static_cast<std::size_t>(k - 1)]) / shape / std::pow(10, body / 20);
}

}  // namespace

TEST_CASE("its orders are six pulses a cycle, no two of them alike, heard through the body") {
  const DieselModel m = default_diesel();
  const DieselPoint& p = m.points.front();
  REQUIRE(p.rpm == 700);
  const double firing = std::abs(strengths(m, p, 6));
  // The body's table ends its truth at the taper, 1600 Hz: order 60 is at 350 Hz.
  for (int k = 1; k <= 60; ++k) {
    CAPTURE(k);
    CHECK(std::abs(strengths(m, p, k + 6) - strengths(m, p, k)) < 0.05 * firing);
    if (k % 6 != 0) {
      CHECK(std::abs(strengths(m, p, k)) < 0.2 * firing);
      if (k % 2 == 1) CHECK(std::abs(strengths(m, p, k)) > 0.001 * firing);  // pairs of cylinders are alike
      CHECK(std::abs(strengths(m, p, 6 - k % 6) - std::conj(strengths(m, p, k % 6))) < 0.05 * firing);
    }
  }
  // Their sum is 5.88: 0.021 of it is the level.
  CHECK(firing == doctest::Approx(0.021 * 5.88).scale(0).epsilon(0.01));
  CHECK(p.orders.size() == static_cast<std::size_t>(2000 / cycles_per_second(700)));
}

TEST_CASE("its body rings at its resonances and not between them") {
  const DieselModel m = default_diesel();
  const auto E = [&](double hz) { return diesel::body_db(m.body, hz); };
  CHECK(E(62) > E(86) + 6);
  CHECK(E(118) > E(86) + 6);
  CHECK(E(118) > E(147) + 6);
  CHECK(E(185) > E(147) + 6);
  CHECK(E(310) > E(240) + 6);
  CHECK(E(455) > E(380) + 5);
  CHECK(E(62) == doctest::Approx(20 * std::log10(1.06)).epsilon(0.15));  // its own and the direct part
  CHECK(E(20) < -12);
}

TEST_CASE("its slow noise halves its density with every scale from an order, and falls over 90 Hz") {
  const DieselModel m = default_diesel();
  const DieselPoint& p = m.points.front();
  const auto P = static_cast<std::size_t>(m.low_channels);
  for (const std::size_t q : {0UL, 9UL, 40UL, 100UL}) {
    for (std::size_t n = 1; n <= static_cast<std::size_t>(m.low_scales); ++n)
      CHECK(double(p.low_variance[q + n * P]) / double(p.low_variance[q + (n - 1) * P]) ==
            doctest::Approx(std::pow(2, 0.7)).epsilon(1e-4));
    const double f = (static_cast<double>(q) + 0.5) / 2 * cycles_per_second(p.rpm);
    if (f < m.body.f_min || f > 500) continue;  // the body's table begins, and is tapered
    const double wanted = 1.2e-4 / (1 + f * f / 8100) * std::pow(10, diesel::body_db(m.body, f) / 10);
    CHECK(double(p.low_variance[q]) / wanted == doctest::Approx(1).epsilon(0.05));
  }
}

TEST_CASE("the middles of channels that lie at one frequency at two speeds are equally noisy") {
  const DieselModel m = default_diesel();
  const DieselPoint &slow = m.points[0], &fast = m.points[1];
  REQUIRE(slow.rpm == 700);
  REQUIRE(fast.rpm == 1300);
  for (std::size_t odd = 1; odd < 36;
       odd += 2)  // (q + 1/2) / 2 orders: 13 odd halves of the one, 7 of the other
    CHECK(slow.low_variance[(13 * odd - 1) / 2] ==
          doctest::Approx(fast.low_variance[(7 * odd - 1) / 2]).scale(0).epsilon(1e-5));
}

TEST_CASE("its hiss bursts with every firing, and grows with the square of the speed") {
  const DieselModel m = default_diesel();
  const std::size_t bands = slot_band_edges(m.slot_samples()).size() - 1;
  const auto v = [&](std::size_t point, std::size_t slot) {
    return double(m.points[point].slot_variance[slot * bands]);
  };
  for (const std::size_t slot : {0UL, 5UL, 17UL, 40UL}) {
    const double steady = 5e-5 * 0.35 / (1500.0 * 1500.0);
    CHECK((v(1, slot) - v(0, slot)) / steady == doctest::Approx(1300.0 * 1300 - 700.0 * 700).epsilon(1e-3));
    CHECK((v(2, slot) - v(1, slot)) / steady == doctest::Approx(2300.0 * 2300 - 1300.0 * 1300).epsilon(1e-3));
  }
  // Of the burst e^-1 is left after 0.12 of the way to the next: slots are 6 / 64 of that.
  const double steady = 5e-5 * 0.35 * std::pow(700 / 1500.0, 2);
  CHECK((v(0, 1) - steady) / (v(0, 0) - steady) == doctest::Approx(std::exp(-6 / 64.0 / 0.12)).epsilon(1e-3));
  CHECK((v(0, 0) - steady) / 5e-5 == doctest::Approx(2.2).epsilon(1e-3));
  // The third cylinder is the strongest: its burst against the first's is the square of their strengths.
  CHECK((v(0, 32) - steady) / (v(0, 0) - steady) == doctest::Approx(0.96 * 0.96).epsilon(1e-3));
  CHECK(double(m.points[0].slot_log_variance[0]) == doctest::Approx(0.5).epsilon(1e-4));
}
