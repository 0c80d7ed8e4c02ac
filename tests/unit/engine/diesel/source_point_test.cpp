// How background points are freed from the body, joined, and laid on the grid of speeds and loads.
#include "diesel/source_point.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diesel/operating_grid.hpp"
#include "engine/heard.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

/// A point at 1000 r/min: one order, everything else of one size.
DieselPoint point_of(const DieselModel& m, double rpm, double load, float order, float variance) {
  DieselPoint p;
  p.rpm = rpm, p.load = load;
  p.orders = {{order, 0}, {0, order / 2}};
  p.low_variance.assign(static_cast<std::size_t>((m.low_scales + 1) * m.low_channels), variance);
  p.slot_variance.assign(static_cast<std::size_t>(m.slots) * (slot_band_edges(m.slot_samples()).size() - 1),
                         variance);
  p.slot_log_variance.assign(static_cast<std::size_t>(m.slots), variance);
  p.slot_correlation = static_cast<double>(variance) / 4;
  return p;
}

/// Speeds 1000 and 2000 at loads 0, 0.5 and 1; the order's level is a product of speed and load.
DieselModel six_points() {
  DieselModel m;
  m.body_filter = {1.0F};
  for (const double load : {1.0, 0.0, 0.5})  // in no order
    for (const double rpm : {2000.0, 1000.0})
      m.points.push_back(point_of(m, rpm, load, static_cast<float>(0.01 * (rpm / 1000) * std::pow(4, load)),
                                  static_cast<float>(0.04 * std::pow(4, load))));
  return m;
}

double level(const SourcePoint& s) { return std::exp(s.level[0]); }

}  // namespace

TEST_CASE("the body's response is linear in dB over octaves, held at its ends, and tapers at 1600 Hz") {
  BodyResponse body;
  body.db = {6, 12, -6};
  const double octave = 1.0 / body.per_octave;
  const auto taper = [](double f) { return 1 / (1 + std::pow(f / 1600, 8)); };
  const auto at = [&](double steps) { return body.f_min * std::pow(2, steps * octave); };
  CHECK(body_db(body, at(0)) == doctest::Approx(6 * taper(at(0))));
  CHECK(body_db(body, at(1)) == doctest::Approx(12 * taper(at(1))));
  CHECK(body_db(body, at(0.25)) == doctest::Approx(7.5 * taper(at(0.25))));
  CHECK(body_db(body, at(1.5)) == doctest::Approx(3 * taper(at(1.5))));
  CHECK(body_db(body, at(2)) == doctest::Approx(-6 * taper(at(2))));
  CHECK(body_db(body, 1e-9) == doctest::Approx(6));
  CHECK(body_db(body, 800) == doctest::Approx(-6 * taper(800)));
  CHECK(body_db(body, 1600) == doctest::Approx(-3));
  CHECK(body_db(body, 3200) == doctest::Approx(-6.0 / 257));
  CHECK(body_db({}, 100) == 0);
}

TEST_CASE("a point's source is its orders and noises as logarithms, the body taken off") {
  DieselModel m = six_points();
  m.body.db = {20, 20};                                                   // tenfold, well below 1600 Hz
  const SourcePoint s = source_of(m, point_of(m, 1200, 0, 0.3F, 0.09F));  // 10 cycles a second
  CHECK(s.level[0] == doctest::Approx(std::log(0.03)).epsilon(1e-6));
  CHECK(s.level[1] == doctest::Approx(std::log(0.015)).epsilon(1e-6));
  CHECK(s.phase[0] == doctest::Approx(0));
  CHECK(s.phase[1] == doctest::Approx(M_PI / 2));
  CHECK(s.hi[5] == doctest::Approx(std::log(0.3)).epsilon(1e-6));
  CHECK(s.s[5] == doctest::Approx(0.3).epsilon(1e-6));
  CHECK(s.rho == doctest::Approx(0.09 / 4).epsilon(1e-6));
  // Channel q of the low layer lies at order (q + 1/2) / 2, in every row.
  const auto P = static_cast<std::size_t>(m.low_channels);
  for (const std::size_t q : {0UL, 7UL, 200UL}) {
    const double body = body_db(m.body, (static_cast<double>(q) + 0.5) / 2 * 10) / 20 * std::log(10);
    CHECK(s.lo[q] == doctest::Approx(std::log(0.3) - body).epsilon(1e-6));
    CHECK(s.lo[q + 2 * P] == doctest::Approx(std::log(0.3) - body).epsilon(1e-6));
  }
  CHECK(std::isfinite(source_of(m, point_of(m, 1200, 0, 0, 0)).level[0]));
}

TEST_CASE("between points levels join geometrically over the octave and over the load") {
  const DieselModel m = six_points();
  for (const double load : {0.0, 0.25, 0.5, 0.7, 1.0})
    for (const double rpm : {1000.0, 1300.0, 1900.0, 2000.0}) {
      CAPTURE(load);
      CAPTURE(rpm);
      const SourcePoint s = SourceMap(m).at(rpm, load);
      CHECK(level(s) == doctest::Approx(0.01 * (rpm / 1000) * std::pow(4, load)).epsilon(1e-5));
      CHECK(std::exp(s.hi[3]) == doctest::Approx(0.2 * std::pow(2, load)).epsilon(1e-5));
      CHECK(std::exp(s.lo[3]) == doctest::Approx(0.2 * std::pow(2, load)).epsilon(1e-5));
    }
  CHECK(level(SourceMap(m).at(500, 0)) == doctest::Approx(0.01).epsilon(1e-5));  // held outside
  CHECK(level(SourceMap(m).at(4000, 0)) == doctest::Approx(0.02).epsilon(1e-5));
  CHECK(level(SourceMap(m).at(1000, -1)) == doctest::Approx(0.01).epsilon(1e-5));
  CHECK(level(SourceMap(m).at(1000, 2)) == doctest::Approx(0.04).epsilon(1e-5));
}

TEST_CASE(
    "spreads and correlation join evenly, phases along the shorter way, what one lacks is the other's") {
  const DieselModel m = six_points();
  SourcePoint a = source_of(m, point_of(m, 1000, 0, 0.1F, 0.04F)), b = a;
  a.phase[0] = 3, b.phase[0] = -3;  // 0.28 rad apart, over pi
  a.s[0] = 0.2, b.s[0] = 0.6, a.rho = 0.1, b.rho = 0.5;
  b.level.push_back(-7), b.phase.push_back(1);
  const SourcePoint y = between(a, b, 0.25);
  CHECK(y.phase[0] == doctest::Approx(3 + 0.25 * (2 * M_PI - 6)));
  a.phase[0] = 0, b.phase[0] = 3.1;  // the one way round is hardly shorter than the other
  CHECK(between(a, b, 0.25).phase[0] == doctest::Approx(0.25 * 3.1));
  b.phase[0] = 3.2;
  CHECK(between(a, b, 0.25).phase[0] == doctest::Approx(0.25 * (3.2 - 2 * M_PI)));
  CHECK(y.s[0] == doctest::Approx(0.3));
  CHECK(y.rho == doctest::Approx(0.2));
  REQUIRE(y.level.size() == 3);
  CHECK(y.level[2] == -7);
  CHECK(y.phase[2] == 1);
  CHECK(between(b, a, 0.25).level[2] == -7);
}

TEST_CASE("a place on the grid lies where speed and load are: 24 steps an octave, 3 between two loads") {
  const OperatingGrid grid(six_points(), kRate);  // from 500 r/min on
  for (const double rpm : {500.0, 510.0, 777.0, 1000.0, 2500.0, 3990.0})
    for (const double load : {0.0, 0.1, 0.5, 0.55, 0.9, 1.0}) {
      CAPTURE(rpm);
      CAPTURE(load);
      const GridPlace place = grid.place(rpm, load);
      double sum = 0;
      for (const double w : place.weight) {
        CHECK(w >= 0);
        sum += w;
      }
      CHECK(sum == doctest::Approx(1));
      // Neighbours in speed are neighbours on the grid, those in load a row apart.
      CHECK(place.index[1] == place.index[0] + 1);
      CHECK(place.index[3] == place.index[2] + 1);
      const double way = 24 * std::log2(rpm / 500);
      const double speed_way = place.weight[1] + place.weight[3];
      const int row = 1 + static_cast<int>(std::ceil(24 * 3.0));
      CHECK(place.index[0] % row + speed_way == doctest::Approx(way).epsilon(1e-9));
      const double load_way = place.weight[2] + place.weight[3];
      const int loads = place.index[0] / row;
      CHECK(place.index[2] - place.index[0] == row);
      CHECK(loads + load_way == doctest::Approx(6 * load).epsilon(1e-9));
    }
  const GridPlace low = grid.place(0, -1), lowest = grid.place(500, 0);
  CHECK(low.index == lowest.index);
  CHECK(low.weight == lowest.weight);
  const GridPlace high = grid.place(9000, 3), highest = grid.place(4000, 1);
  CHECK(high.index == highest.index);
  CHECK(high.weight[3] == doctest::Approx(1));
}

TEST_CASE("with one load the grid has one row") {
  DieselModel m = six_points();
  m.points.erase(m.points.begin() + 2, m.points.end());
  const OperatingGrid grid(m, kRate);
  const GridPlace place = grid.place(1500, 0.3);
  CHECK(place.weight[2] == 0);
  CHECK(place.weight[3] == 0);
  CHECK(place.weight[0] + place.weight[1] == doctest::Approx(1));
}

TEST_CASE(
    "a state of the grid holds the waves and noises of its speed and load, with the body put on again") {
  DieselModel m = six_points();
  m.body.db = {20, 20};
  const OperatingGrid grid(m, kRate);
  const GridPlace place = grid.place(1000, 0.5);
  std::vector<double> table(static_cast<std::size_t>(m.angle_samples));
  grid.mix(place, &OperatingState::table, 0, m.angle_samples, table.data());
  for (std::size_t n = 0; n < table.size(); n += 97) {
    const double angle = 2 * M_PI * static_cast<double>(n) / m.angle_samples;
    // Order 1 a cosine, order 2 half as large and a quarter turn ahead.
    CHECK(table[n] ==
          doctest::Approx(0.02 * std::cos(angle) - 0.01 * std::sin(2 * angle)).scale(0.02).epsilon(1e-3));
  }
  double hi[4], lo[4], s[4];
  grid.mix(place, &SlotStatistics::hi, 2, 4, hi);
  grid.mix(place, &OperatingState::lo, 300, 4, lo);
  grid.mix(place, &SlotStatistics::s, 60, 4, s);
  for (int i = 0; i < 4; ++i) {
    CHECK(hi[i] == doctest::Approx(std::sqrt(0.08)).epsilon(1e-3));
    CHECK(lo[i] == doctest::Approx(std::sqrt(0.08)).epsilon(1e-3));
    CHECK(s[i] == doctest::Approx(std::sqrt(0.08)).epsilon(1e-2));
  }
  CHECK(grid.rho(place) == doctest::Approx(0.02).scale(0).epsilon(1e-2));
}

TEST_CASE("orders fade out between 0.42 and 0.46 of the sampling rate") {
  DieselModel m = six_points();
  m.points.resize(2);
  m.angle_samples = 8192, m.slots = 128;
  for (DieselPoint& p : m.points) {
    p = point_of(m, p.rpm, 0, 0.0F, 0.01F);
    p.orders.assign(2000, {0, 0});
    p.orders[1999] = {0.1F, 0};
  }
  const OperatingGrid grid(m, kRate);
  const auto peak = [&](double share) {  // of the rate, where order 2000 lies
    std::vector<double> table(8192);
    grid.mix(grid.place(share * kRate / 2000 * 120, 0), &OperatingState::table, 0, 8192, table.data());
    double most = 0;
    for (const double x : table) most = std::max(most, std::fabs(x));
    return most;
  };
  CHECK(peak(0.38) == doctest::Approx(0.1).scale(0).epsilon(0.01));
  CHECK(peak(0.44) < 0.09);
  CHECK(peak(0.44) > 0.01);
  CHECK(peak(0.49) == doctest::Approx(0).scale(1));
}
