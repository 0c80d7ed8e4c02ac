// The fit of an allpass to a wanted lag: where it begins, what it finds, how fast.
#include "tool/design/allpass_fit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tool/design/loop_response.hpp"

using namespace rigsound;
using namespace rigsound::tool;

namespace {

Allpass known(int first_orders) {
  Allpass allpass;
  allpass.sections = 3;
  allpass.section[0] = {0.05, 0.01};
  allpass.section[1] = {0.4, 0.2};
  allpass.section[2] = {1.1, 1.7};
  allpass.first_orders = first_orders;
  allpass.a = 0.6;
  return allpass;
}

std::vector<LagPoint> points_of(const Allpass& allpass, int count = 40) {
  std::vector<LagPoint> points;
  for (int i = 1; i <= count; ++i) {
    const double omega = 2.8 * i / count;
    points.push_back({omega, lag(allpass, omega), 1 + 0.5 * (i % 3)});
  }
  return points;
}

Allpass detuned(Allpass allpass, double share) {
  for (std::size_t i = 0; i < 3; ++i) {
    allpass.section[i].b *= 1 + share;
    allpass.section[i].c *= 1 - share;
  }
  allpass.a *= 1 + share;
  return allpass;
}

double cost(const Allpass& allpass, const std::vector<LagPoint>& points) {
  double sum = 0;
  for (const LagPoint& p : points) sum += std::pow(p.weight * (lag(allpass, p.omega) - p.lag), 2);
  return sum;
}

double worst(const Allpass& allpass, const std::vector<LagPoint>& points) {
  double most = 0;
  for (const LagPoint& p : points)
    most = std::max(most, std::fabs(p.weight * (lag(allpass, p.omega) - p.lag)));
  return most;
}

double distance(const Allpass& a, const Allpass& b) {
  double most = a.first_orders > 0 ? std::fabs(std::log(a.a / b.a)) : 0;
  for (std::size_t i = 0; i < 3; ++i)
    most = std::max({most, std::fabs(std::log(a.section[i].b / b.section[i].b)),
                     std::fabs(std::log(a.section[i].c / b.section[i].c))});
  return most;
}

}  // namespace

TEST_CASE("an allpass is found again from its own lag, with errors that square from step to step") {
  for (const int first_orders : {0, 1}) {
    CAPTURE(first_orders);
    const Allpass wanted = known(first_orders);
    const std::vector<LagPoint> points = points_of(wanted);
    const Allpass start = detuned(wanted, 0.15);
    CHECK(distance(fit_lag(start, points, 0, 0), start) == 0);
    CHECK(distance(fit_lag(start, points, 4, 0), wanted) < 2e-3);
    CHECK(distance(fit_lag(start, points, 6, 0), wanted) < 1e-6);
    CHECK(distance(fit_lag(start, points, 9, 0), wanted) < 1e-11);
  }
}

TEST_CASE("a lag that no allpass has is met as nearly as can be in the sum of squares") {
  for (const int first_orders : {0, 1}) {
    std::vector<LagPoint> points = points_of(known(first_orders));
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].lag += 0.05 * std::sin(3.0 * static_cast<double>(i * i));
    const Allpass found = fit_lag(detuned(known(first_orders), 0.1), points, 60, 0);
    const double least = cost(found, points);
    const auto moved = [&](double by, std::size_t section, int what) {
      Allpass other = found;
      (what == 0 ? other.section[section].b : what == 1 ? other.section[section].c : other.a) *= 1 + by;
      return cost(other, points);
    };
    for (const double by : {-1e-3, 1e-3})
      for (std::size_t section = 0; section < 3; ++section) {
        CHECK(moved(by, section, 0) > least);
        CHECK(moved(by, section, 1) > least);
        if (first_orders > 0) CHECK(moved(by, section, 2) > least);
      }
  }
}

TEST_CASE("the fit ends once every residual is good enough, and not before") {
  const Allpass wanted = known(1);
  const std::vector<LagPoint> points = points_of(wanted);
  const Allpass start = detuned(wanted, 0.15);
  int steps = 1;
  while (worst(fit_lag(start, points, steps, 0), points) >= 1e-6) ++steps;
  const Allpass first_good = fit_lag(start, points, steps, 0), ended = fit_lag(start, points, 100, 1e-6);
  CHECK(distance(first_good, ended) == 0);
  CHECK(steps > 2);
}

TEST_CASE("a start far away is led down, however long the steps it would like to take") {
  const Allpass wanted = known(1);
  const std::vector<LagPoint> points = points_of(wanted);
  for (const double share : {-0.6, 0.6, 0.9}) {
    CAPTURE(share);
    double before = cost(detuned(wanted, share), points);
    for (int steps = 1; steps < 12; ++steps) {
      const double now = cost(fit_lag(detuned(wanted, share), points, steps, 0), points);
      CHECK((now < before || now < 1e-20));
      before = now;
    }
    CHECK(distance(fit_lag(detuned(wanted, share), points, 60, 0), wanted) < 1e-9);
  }
}

TEST_CASE("the first guess gives every section one turn of the wanted lag") {
  // A straight line of 3 turns at half the rate: turn m ends at m / 3 of it.
  std::vector<LagPoint> points;
  for (int i = 1; i < 97; ++i) points.push_back({M_PI * i / 100, 6 * M_PI * i / 100, 1});
  const auto tangent = [](double share) { return std::tan(M_PI * share / 2); };
  for (const double width : {1.2, 0.7}) {
    const Allpass even = sliced_allpass(points, 6, width);
    CHECK(even.sections == 3);
    CHECK(even.first_orders == 0);
    CHECK(even.section[0].c == doctest::Approx(std::pow(tangent(1 / 6.0), 2)).epsilon(1e-9));
    CHECK(even.section[1].c == doctest::Approx(std::pow(tangent(3 / 6.0), 2)).epsilon(1e-9));
    CHECK(even.section[2].c == doctest::Approx(std::pow(tangent(5 / 6.0), 2)).epsilon(1e-9));
    CHECK(even.section[0].b == doctest::Approx(width * tangent(2 / 6.0)).epsilon(1e-9));
    CHECK(even.section[1].b == doctest::Approx(width * (tangent(4 / 6.0) - tangent(2 / 6.0))).epsilon(1e-9));
    // The last turn ends at half the rate, where no section is infinitely wide.
    CHECK(even.section[2].b ==
          doctest::Approx(width * (std::tan((M_PI - 0.05) / 2) - tangent(4 / 6.0))).epsilon(1e-9));
  }
  // Half a turn goes to the section of first order, at the bottom.
  for (LagPoint& p : points) p.lag *= 7 / 6.0;
  const Allpass odd = sliced_allpass(points, 7, 1);
  CHECK(odd.sections == 3);
  CHECK(odd.first_orders == 1);
  CHECK(odd.a == doctest::Approx(tangent(0.5 / 7)).epsilon(1e-9));
  CHECK(odd.section[0].c == doctest::Approx(std::pow(tangent(2 / 7.0), 2)).epsilon(1e-9));
  CHECK(odd.section[0].b == doctest::Approx(tangent(3 / 7.0) - tangent(1 / 7.0)).epsilon(1e-9));
}

TEST_CASE("the first guess follows a bent lag, falls to no side where it falls, and stays below its total") {
  // Half of four turns within the lowest tenth, then a straight line.
  std::vector<LagPoint> points;
  for (int i = 1; i <= 10; ++i) points.push_back({0.1 * M_PI * i / 10, 4 * M_PI * i / 10, 1});
  for (int i = 1; i <= 8; ++i) points.push_back({0.1 * M_PI + 0.1 * M_PI * i, 4 * M_PI + 0.4 * M_PI * i, 1});
  const Allpass bent = sliced_allpass(points, 8, 1);
  const auto tangent = [](double share) { return std::tan(M_PI * share / 2); };
  CHECK(bent.section[0].c == doctest::Approx(std::pow(tangent(0.025), 2)).epsilon(1e-9));
  CHECK(bent.section[1].c == doctest::Approx(std::pow(tangent(0.075), 2)).epsilon(1e-9));
  CHECK(bent.section[1].b == doctest::Approx(tangent(0.1) - tangent(0.05)).epsilon(1e-9));
  // More turns than the order has are squeezed into it; a lag that falls is held.
  std::vector<LagPoint> much = points;
  for (LagPoint& p : much) p.lag *= 10;
  const Allpass squeezed = sliced_allpass(much, 8, 1);
  for (std::size_t m = 0; m + 1 < 4; ++m) CHECK(squeezed.section[m].c < squeezed.section[m + 1].c);
  std::vector<LagPoint> falling = points;
  falling[4].lag = 0;
  const Allpass held = sliced_allpass(falling, 8, 1);
  for (std::size_t m = 0; m < 4; ++m) {
    CHECK(held.section[m].b > 0);
    CHECK(held.section[m].c > 0);
  }
  CHECK(held.section[1].c == doctest::Approx(bent.section[1].c).epsilon(1e-6));
}
