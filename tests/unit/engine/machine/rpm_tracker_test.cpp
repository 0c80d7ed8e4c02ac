// Speeds between messages: the trend's formula, and the tracker against the filter that it is.
#include "rigsound/machine/rpm_tracker.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <utility>

using namespace rigsound;

TEST_CASE("a trend holds its slope for a quarter of a second, then lets it decay with 0.1 s") {
  for (const double slope : {900.0, -900.0}) {
    const SpeedTrend trend{1500, slope};
    for (const double age_s : {0.0, 0.02, 0.1, 0.25}) {
      CHECK(trend.at(age_s) == doctest::Approx(1500 + slope * age_s).epsilon(1e-12));
      CHECK(trend.slope_at(age_s) == slope);
    }
    for (const double age_s : {0.26, 0.35, 0.6, 5.0}) {
      const double left = std::exp((0.25 - age_s) / 0.1);
      CHECK(trend.at(age_s) == doctest::Approx(1500 + slope * (0.25 + 0.1 * (1 - left))).epsilon(1e-12));
      CHECK(trend.slope_at(age_s) == doctest::Approx(slope * left).epsilon(1e-12));
    }
  }
}

TEST_CASE("a trend never turns backwards") {
  const SpeedTrend trend{100, -1000};
  CHECK(trend.at(0.05) == doctest::Approx(50));
  CHECK(trend.at(0.2) == 0);
  CHECK(SpeedTrend{-3, 0}.at(1) == 0);
  CHECK(SpeedTrend{700, 0}.at(99) == 700);
}

TEST_CASE("the tracker settles as a critically damped filter of 50 rad/s at 20 ms, of 25 at 100 ms") {
  struct Case {
    double interval_s, bandwidth_rad_s;
  };
  for (const Case& c : {Case{0.01, 50}, Case{0.02, 50}, Case{0.06, 37.5}, Case{0.1, 25}, Case{0.2, 25}}) {
    CAPTURE(c.interval_s);
    RpmTracker tracker;
    double time_s = 0;
    for (int i = 0; i < 200; ++i) tracker.message(time_s += c.interval_s, 1000);
    // Both poles at rho: of a step, what a message is ahead of the prediction falls as
    // (k + 1) rho^k - k rho^(k - 1).
    const double rho = std::exp(-c.bandwidth_rad_s * c.interval_s), step = 20;
    for (int k = 0; k < 6; ++k) {
      CAPTURE(k);
      time_s += c.interval_s;
      const double ahead = 1000 + step - tracker.at(time_s).rpm;
      const double expected = (k + 1) * std::pow(rho, k) - (k > 0 ? k * std::pow(rho, k - 1) : 0);
      CHECK(ahead == doctest::Approx(step * expected).scale(step).epsilon(1e-3));
      tracker.message(time_s, 1000 + step);
    }
  }
}

TEST_CASE("a ramp is followed without error, by its slope") {
  RpmTracker tracker;
  const double time_s = 2;
  for (int i = 0; i <= 100; ++i) tracker.message(0.02 * i, 800 + 900 * 0.02 * i);
  CHECK(tracker.at(time_s).slope == doctest::Approx(900).epsilon(1e-6));
  CHECK(tracker.at(time_s + 0.1).rpm == doctest::Approx(800 + 900 * (time_s + 0.1)).epsilon(1e-6));
}

TEST_CASE("what no flywheel does is taken as it is, without a slope, and so is the first message") {
  RpmTracker tracker;
  tracker.message(5, 1000);
  CHECK(tracker.at(5).rpm == 1000);
  CHECK(tracker.at(5).slope == 0);
  tracker.message(5.02, 1119);  // 11.9 %
  CHECK(tracker.at(5.02).rpm < 1119);
  CHECK(tracker.at(5.02).slope > 0);
  for (const double jump : {1.3, 0.7}) {
    RpmTracker jumped;
    for (int i = 0; i < 50; ++i) jumped.message(0.02 * i, 1000 + i);
    CHECK(jumped.at(0.98).slope > 0);
    jumped.message(1, 1000 * jump);
    CHECK(jumped.at(1).rpm == 1000 * jump);
    CHECK(jumped.at(1).slope == 0);
  }
  // 12 % of the higher of the two speeds, whichever came first.
  for (const auto& [followed, taken] : {std::pair{1135.0, 1138.0}, {881.0, 879.0}}) {
    for (const double rpm : {followed, taken}) {
      RpmTracker tracked;
      for (int i = 0; i < 50; ++i) tracked.message(0.02 * i, 1000);
      tracked.message(1, rpm);
      CAPTURE(rpm);
      CHECK((tracked.at(1).slope == 0) == (rpm == taken));
    }
  }
  RpmTracker stopped;
  stopped.message(0, 0);
  stopped.message(0.02, 1);
  CHECK(stopped.at(0.02).rpm == 1);
}

TEST_CASE("after a second without a message the next one begins anew, and none acts before its time") {
  for (const double pause_s : {0.99, 1.01}) {
    RpmTracker tracker;
    for (int i = 0; i < 50; ++i) tracker.message(0.02 * i, 1000);
    tracker.message(0.98 + pause_s, 1050);
    CHECK((tracker.at(2).slope == 0) == (pause_s > 1));
  }
  RpmTracker tracker;
  tracker.message(1, 1000);
  tracker.message(1, 1100);  // not later
  tracker.message(0.5, 1100);
  CHECK(tracker.at(1).rpm == 1000);
  CHECK(tracker.at(0).rpm == 1000);
}
