// The files beside a simulated feed ramp, read by what reads them in use.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "analyzer/bus_course.hpp"
#include "rigsound/analysis/labels.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/simulate.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

TEST_CASE(
    "the bus beside a feed ramp says what the demonstration rig understands, at the recording's own time") {
  const Workplace at;
  write_feed_ramp(at / "", 4, 15);
  CHECK(recording_seconds(at / "feed/ramp.wav") == doctest::Approx(15));
  const BusCourse course = read_bus_course(config::load_rig(std::string(RIGSOUND_CONFIG) + "/rigs/demo.toml"),
                                           at / "feed/ramp.log");
  CHECK(static_cast<double>(course.moments.size()) * kBusStep_s == doctest::Approx(15).epsilon(0.01));
  const auto moment = [&](double s) { return course.moments.at(static_cast<std::size_t>(s / kBusStep_s)); };
  CHECK_FALSE(moment(0.5).situation.has_value());
  CHECK_FALSE(moment(14.6).situation.has_value());
  for (const double s : {2.0, 5.0, 7.5, 10.0, 13.0}) {
    const double feed = 35 + 130 * (s - 1) / 13;
    CHECK(moment(s).feed_bar == doctest::Approx(feed).epsilon(0.02));
    CHECK(moment(s).rods == 1);
    CHECK(moment(s).rock == -1);  // the demonstration rig takes it from Modbus
  }
  CHECK(moment(2).situation == Situation::kUnderfeed);
  CHECK(moment(7.5).situation == Situation::kNormal);
  CHECK(moment(13).situation == Situation::kOverfeed);
  CHECK(moment(7.5).rpm == doctest::Approx(1900 + 2.2 * 10).epsilon(0.01));

  const std::vector<analysis::Label> labels = read_labels(at / "feed/ramp.txt");
  REQUIRE(labels.size() == 13);
  for (const analysis::Label& label : labels) {
    const double middle = (label.start_s + label.end_s) / 2;
    CHECK(label.feed_bar == doctest::Approx(35 + 130 * (middle - 1) / 13).epsilon(0.001));
    CHECK(label.percussion_bar == 150);
  }
}
