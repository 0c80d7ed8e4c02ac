// Which models of a diesel can be played, and what is said of the others.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>
#include <vector>

#include "diesel/diesel_layer.hpp"
#include "engine/heard.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

template <class Change>
std::string complaint_after(Change change) {
  static const DieselModel kValid = default_diesel();
  DieselModel model = kValid;
  change(model);
  try {
    require_valid(model);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

template <class Change>
bool told(Change change, const char* words) {
  return complaint_after(change).find(words) != std::string::npos;
}

/// 1, a[1], ... with these pairs of poles.
std::vector<float> all_pole(const std::vector<std::complex<double>>& poles) {
  std::vector<double> a = {1};
  for (const std::complex<double> pole : poles) {
    a.resize(a.size() + 2, 0.0);
    for (std::size_t i = a.size() - 1; i >= 1; --i)
      a[i] += -2 * pole.real() * a[i - 1] + (i >= 2 ? std::norm(pole) * a[i - 2] : 0.0);
  }
  return {a.begin(), a.end()};
}

}  // namespace

TEST_CASE("a filter is taken if all its poles are inside the unit circle, and not if one pair is outside") {
  const dsp::RandomField random(3, 1);
  for (std::uint64_t trial = 0; trial < 50; ++trial)
    for (const std::size_t pairs : {1UL, 2UL, 3UL, 4UL}) {
      std::vector<std::complex<double>> poles;
      for (std::uint64_t i = 0; i < pairs; ++i)
        poles.push_back(
            std::polar(0.3 + 0.67 * random.uniform(trial, 2 * i), M_PI * random.uniform(trial, 2 * i + 1)));
      CAPTURE(trial);
      CAPTURE(pairs);
      CHECK(complaint_after([&](DieselModel& m) { m.body_filter = all_pole(poles); }).empty());
      poles[trial % pairs] =
          std::polar(1.03 + 0.3 * random.uniform(trial, 99), std::arg(poles[trial % pairs]));
      CHECK(
          told([&](DieselModel& m) { m.body_filter = all_pole(poles); }, "A: is no stable all-pole filter"));
    }
}

TEST_CASE("a filter begins with 1 and has order 256 at most, or is not there") {
  CHECK(
      complaint_after([](DieselModel& m) { m.body_filter.assign(257, 0.0F), m.body_filter[0] = 1; }).empty());
  CHECK(told([](DieselModel& m) { m.body_filter.assign(258, 0.0F), m.body_filter[0] = 1; },
             "A: has order 257, expected at most 256"));
  CHECK(complaint_after([](DieselModel& m) { m.body_filter.clear(); }).empty());
  CHECK(complaint_after([](DieselModel& m) { m.body_filter = {1}; }).empty());
  CHECK(told([](DieselModel& m) { m.body_filter = {0.5F, 0.1F}; }, "A: is no stable all-pole filter"));
  CHECK(told([](DieselModel& m) { m.body_filter = {1, 1}; }, "A: is no stable all-pole filter"));
  CHECK(told([](DieselModel& m) { m.hydraulic.flow_filter = {1, -1.5F}; }, "hydraulic.flow_A: is no stable"));
}

TEST_CASE("what a point holds has the size that the model's angles, slots and channels ask for") {
  const auto orders = [](std::size_t count) {
    return [count](DieselModel& m) { m.points[1].orders.assign(count, {0, 0}); };
  };
  const auto half = static_cast<std::size_t>(default_diesel().angle_samples) / 2;
  CHECK(complaint_after(orders(half - 1)).empty());
  CHECK(told(orders(half), "points[1].order_level_db: has 2048 orders, expected fewer than N_theta / 2"));
  for (const int more : {-1, 1}) {
    const auto resized = [more](auto DieselPoint::*member) {
      return [more, member](DieselModel& m) {
        auto& values = m.points[2].*member;
        values.resize(values.size() + static_cast<std::size_t>(more));
      };
    };
    CHECK(told(resized(&DieselPoint::low_variance), "points[2].v_lo_db: has "));
    CHECK(told(resized(&DieselPoint::slot_variance), "points[2].v_hi_db: has "));
    CHECK(told(resized(&DieselPoint::slot_log_variance), "points[2].s2: has "));
    CHECK(told(
        [more](DieselModel& m) {
          const auto size = static_cast<std::size_t>(m.angle_samples * 5 / 4);
          m.points[0].grains = {std::vector<float>(size),
                                std::vector<float>(size + static_cast<std::size_t>(more))};
        },
        "points[0].grains: has "));
  }
  CHECK(complaint_after([](DieselModel& m) {
          m.points[0].grains = {std::vector<float>(static_cast<std::size_t>(m.angle_samples * 5 / 4))};
        }).empty());
}

TEST_CASE("a body's response has no value or two and more, and slots have 16 to 512 samples") {
  CHECK(complaint_after([](DieselModel& m) { m.body.db.clear(); }).empty());
  CHECK(told([](DieselModel& m) { m.body.db.resize(1); }, "E.db: has one value"));
  CHECK(complaint_after([](DieselModel& m) { m.body.db.resize(2); }).empty());
  CHECK(
      told([](DieselModel& m) { m.angle_samples = 1024, m.slots = 128; }, "L: leaves 8, expected 16...512"));
  CHECK(told([](DieselModel& m) { m.angle_samples = 16384; }, "N_theta: is 16384"));
}

TEST_CASE("a model that cannot be played is refused by name") {
  const auto refused = [](auto change, const char* word) {
    DieselModel model = default_diesel();
    change(model);
    CHECK_THROWS_WITH_AS(DieselLayer({model}, kRate, 1, 800), doctest::Contains(word), std::invalid_argument);
  };
  refused([](auto& m) { m.points.clear(); }, "point");
  refused([](auto& m) { m.angle_samples = 5000; }, "N_theta");
  refused([](auto& m) { m.points[1].slot_variance.pop_back(); }, "v_hi");
  refused([](auto& m) { m.body_filter = {1.0F, -2.1F}; }, "stable");
  refused([](auto& m) { m.points[1].slot_log_variance[3] = 2.5F; }, "points[1].s2: is 2.5, expected 0...2");
  refused([](auto& m) { m.points[0].slot_correlation = 0.96; }, "points[0].rho: is 0.96, expected 0...0.95");
  refused([](auto& m) { m.points[0].rpm = 299; }, "points[0].rpm: is 299 r/min, expected 300...4000 r/min");
  refused([](auto& m) { m.hydraulic.flow = std::nan(""); }, "hydraulic.flow: is nan");
  refused([](auto& m) { m.slots = 48; }, "L: is 48, expected a power of two");
}
