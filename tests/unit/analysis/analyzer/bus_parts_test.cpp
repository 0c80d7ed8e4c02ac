// How a recorded bus cuts a recording into parts.
#include "analyzer/bus_parts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "analyzer/part_list.hpp"
#include "rigsound/analysis/simulate.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

BusCourse course_of(double seconds, const std::function<void(double, BusMoment&)>& say) {
  BusCourse course;
  for (double t = 0; t < seconds - 1e-9; t += kBusStep_s) {
    BusMoment moment;
    moment.situation = Situation::kNormal;
    moment.feed_bar = 90, moment.rods = 2, moment.rpm = 1900;
    say(t, moment);
    course.moments.push_back(moment);
  }
  return course;
}

/// What the pump shakes the feed with.
double ripple(double t) { return 1.5 * std::sin(40 * t) + 0.8 * std::sin(97 * t); }

}  // namespace

TEST_CASE("a steady feed is one part, however long, with the means of its own time") {
  const BusCourse course = course_of(30, [](double t, BusMoment& m) {
    if (t < 3 || t >= 20) m.situation.reset();
    m.feed_bar = 90 + ripple(t), m.percussion_bar = t < 11.5 ? 150 : 170, m.rock = 1;
  });
  const BusParts parts = bus_parts(course, 0, 30, {"granite", "marble"});
  REQUIRE(parts.labels.size() == 1);
  const analysis::Label& label = parts.labels[0];
  CHECK(label.start_s == doctest::Approx(3 + kSettle_s).epsilon(0.01));
  CHECK(label.end_s == doctest::Approx(20 - kSettle_s).epsilon(0.01));
  CHECK(label.situation == Situation::kNormal);
  CHECK(label.feed_bar == doctest::Approx(90).epsilon(0.005));
  CHECK(label.percussion_bar == doctest::Approx(160).epsilon(0.005));
  CHECK(label.rods == 2);
  CHECK(label.rock == "marble");
  CHECK(label.rpm == 1900);
  CHECK(parts.notes.empty());
}

TEST_CASE("a feed that moves is cut into equal parts of at most ten bar, ripple and all") {
  const BusCourse course =
      course_of(40, [](double t, BusMoment& m) { m.feed_bar = 65 + 45 * t / 40 + ripple(t); });
  const BusParts parts = bus_parts(course, 0, 40, {});
  REQUIRE(parts.labels.size() == 5);
  for (std::size_t i = 0; i < parts.labels.size(); ++i) {
    const analysis::Label& label = parts.labels[i];
    const double middle = (label.start_s + label.end_s) / 2;
    CHECK(label.end_s - label.start_s == doctest::Approx(39.4 / 5).epsilon(0.1));
    CHECK(label.feed_bar == doctest::Approx(65 + 45 * middle / 40).epsilon(0.01));
    if (i > 0) CHECK(label.start_s == doctest::Approx(parts.labels[i - 1].end_s));
  }
}

TEST_CASE("what is too short to learn from is left out and told; a burst of rattling may be short") {
  const BusCourse course = course_of(20, [](double t, BusMoment& m) {
    if (t < 2) m.situation = Situation::kUnderfeed;
    if (t >= 8 && t < 9.2) m.situation = Situation::kOpenRattling;
    if (t >= 12) m.feed_bar = 90 + 60 * (t - 12);  // 60 bar a second: nothing stands still
  });
  const BusParts parts = bus_parts(course, 0, 20, {});
  REQUIRE(parts.labels.size() == 3);
  CHECK(parts.labels[0].situation == Situation::kNormal);
  CHECK(parts.labels[0].start_s == doctest::Approx(2.3).epsilon(0.01));
  CHECK(parts.labels[1].situation == Situation::kOpenRattling);
  CHECK(parts.labels[1].feed_bar == 0);
  CHECK(parts.labels[2].end_s < 12.3);
  REQUIRE(parts.notes.size() == 1);
  CHECK(parts.notes[0].find("left out") != std::string::npos);
}

TEST_CASE("rods and rock cut too, and the offset shifts the log against the recording") {
  const BusCourse course = course_of(20, [](double t, BusMoment& m) { m.rods = t < 10 ? 1 : 2; });
  for (const double offset_s : {0.0, 2.5, -4.0}) {
    const BusParts parts = bus_parts(course, offset_s, 18, {});
    REQUIRE(parts.labels.size() == 2);
    CHECK(parts.labels[0].rods == 1);
    CHECK(parts.labels[0].end_s == doctest::Approx(10 - kSettle_s + offset_s).epsilon(0.01));
    CHECK(parts.labels[1].rods == 2);
    CHECK(parts.labels[0].start_s >= 0);
    CHECK(parts.labels[1].end_s <= 18);
  }
}

namespace {

AnalyzerOptions by_bus(const Workplace& at) {
  AnalyzerOptions options = options_for(at, "set");
  options.inputs = {at / "feed/ramp.wav"};
  options.rig = std::string(RIGSOUND_CONFIG) + "/rigs/demo.toml";
  return options;
}

}  // namespace

TEST_CASE("a bus log beside a recording wins over its labels, but only with a rig that describes the bus") {
  const Workplace at;
  write_feed_ramp(at / "", 4, 42);
  AnalyzerOptions options = by_bus(at);
  const std::vector<Part> parts = list_parts(options).parts;
  CHECK(parts.size() >= 12);
  for (const Part& p : parts) {
    CHECK(p.labels == at / "feed/ramp.log");
    const double middle = (p.label.start_s + p.label.end_s) / 2;
    CHECK(p.label.feed_bar == doctest::Approx(35 + 130 * (middle - 1) / 40).epsilon(0.01));
  }
  options.rig.clear();
  CHECK(list_parts(options).parts.front().labels == at / "feed/ramp.txt");

  options = by_bus(at);
  std::filesystem::rename(at / "feed/ramp.log", at / "bus.log");
  options.bus_log = at / "bus.log";
  options.bus_log_offset_s = -3;
  CHECK(list_parts(options).parts.front().label.start_s < parts.front().label.start_s);
  options.inputs.push_back(at / "feed/ramp.wav");
  CHECK_THROWS_AS(list_parts(options), InputError);
}

TEST_CASE(
    "a bus log that says nothing of the feed, or of other minutes, leaves its recording without a bank") {
  const Workplace at;
  write_feed_ramp(at / "", 4, 12);
  AnalyzerOptions options = by_bus(at);
  options.bus_log_offset_s = 100;
  PartList list = list_parts(options);
  CHECK(list.parts.empty());
  REQUIRE(list.failures.size() == 1);
  CHECK(list.failures[0].find("ramp.log: has no drilling within the recording") != std::string::npos);
  write_text(at / "feed/ramp.log", "(1733212800.000000) can0 0CF00400#FFFFFF803EFFFFFF\n");
  options.bus_log_offset_s = 0;
  list = list_parts(options);
  REQUIRE(list.failures.size() == 1);
  CHECK(list.failures[0].find("ramp.log: says nothing of feed_pressure_bar") != std::string::npos);
  options.rig = at / "none.toml";
  CHECK_THROWS_AS(list_parts(options), InputError);
}
