// Units and ranges of a DBC against those of the machine's signals: what is doubted, and what is meant.
#include "rig/plausibility.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "rig/units.hpp"

using namespace rigsound;
using config::MappedSignal;
using config::Quantity;

namespace {

MappedSignal mapped(Signal target, const char* name, const char* unit, double min = 0, double max = 0) {
  MappedSignal s;
  s.target = {target};
  s.where = "rig.toml:7: key";
  s.name = name;
  s.unit = unit;
  s.min = min, s.max = max;
  return s;
}

/// What is doubted of the first of these; empty: nothing.
std::string doubt(std::initializer_list<MappedSignal> signals) {
  const std::vector<std::string> all = config::doubts(signals);
  const std::string where = "rig.toml:7: key: ";
  if (all.empty() || all[0].find(signals.begin()->name) != where.size()) return {};
  CHECK(all[0].rfind(where, 0) == 0);
  return all[0].substr(where.size());
}

std::string doubt_scaled(MappedSignal s, double scale, double offset = 0) {
  s.scale = scale, s.offset = offset;
  return doubt({s});
}

constexpr Signal kFeed = Signal::kFeedPressureBar, kRpm = Signal::kEngineRpm, kLoad = Signal::kEngineLoad,
                 kRods = Signal::kRodCount, kRate = Signal::kPercussionRateHz,
                 kPosition = Signal::kFeedPositionM;

}  // namespace

TEST_CASE("the signal's own unit, no unit and what is no unit are not doubted") {
  for (const char* unit : {"bar", "Bar", " BARG", "bara", "", "count", "state"})
    CHECK(doubt({mapped(kFeed, "A.P", unit)}).empty());
  for (const char* unit : {"rpm", "1/min", "r/min", "U/min"})
    CHECK(doubt({mapped(kRpm, "A.N", unit)}).empty());
  CHECK(doubt({mapped(kRods, "A.R", "")}).empty());
  CHECK(doubt({mapped(kLoad, "A.L", "")}).empty());
}

TEST_CASE("another unit of the same quantity wants the scale between them") {
  CHECK(doubt({mapped(kFeed, "A.P", "kPa")}) == "A.P is in kPa, feed_pressure_bar in bar: scale = 0.01?");
  CHECK(doubt({mapped(kFeed, "A.P", "MPa")}) == "A.P is in MPa, feed_pressure_bar in bar: scale = 10?");
  CHECK(doubt({mapped(kRpm, "A.N", "1/s")}) == "A.N is in 1/s, engine_rpm in r/min: scale = 60?");
  CHECK(doubt({mapped(kPosition, "A.X", "mm")}) == "A.X is in mm, feed_position_m in m: scale = 0.001?");
  CHECK(doubt({mapped(kLoad, "A.L", "%")}) == "A.L is in %, engine_load in shares of 1: scale = 0.01?");
  CHECK(doubt_scaled(mapped(kFeed, "A.P", "kPa"), 0.1) ==
        "A.P is in kPa, feed_pressure_bar in bar, the rig's scale is 0.1: scale = 0.01?");
  CHECK(doubt_scaled(mapped(kFeed, "A.P", "kPa"), 0.01).empty());
  CHECK(doubt_scaled(mapped(kFeed, "A.P", "psi"), 0.069).empty());  // nobody writes 0.0689475729
  CHECK_FALSE(doubt_scaled(mapped(kFeed, "A.P", "psi"), 0.0699).empty());
  CHECK_FALSE(doubt_scaled(mapped(kFeed, "A.P", "psi"), 0.068).empty());
}

TEST_CASE("a unit of another quantity is another signal, or that with which it was swapped") {
  CHECK(doubt({mapped(kFeed, "A.P", "rpm")}) == "A.P is in rpm, feed_pressure_bar in bar: another signal?");
  CHECK(doubt({mapped(kFeed, "A.T", "degC")}) == "A.T is in degC, feed_pressure_bar in bar: another signal?");
  CHECK(doubt({mapped(kRods, "A.R", "bar")}) == "A.R is in bar, rod_count a whole number: another signal?");
  CHECK(doubt({mapped(kFeed, "A.N", "rpm"), mapped(kRpm, "A.P", "bar")}) ==
        "A.N is in rpm, feed_pressure_bar in bar: swapped with engine_rpm?");
  CHECK(doubt({mapped(kFeed, "A.N", "rpm"), mapped(kRpm, "A.P", "")}) ==
        "A.N is in rpm, feed_pressure_bar in bar: another signal?");  // it may be right as it is
  CHECK(doubt({mapped(kFeed, "A.N", "rpm"), mapped(kRpm, "A.X", "m")}) ==
        "A.N is in rpm, feed_pressure_bar in bar: another signal?");
  CHECK(doubt({mapped(kFeed, "A.N", "rpm"), mapped(kPosition, "A.P", "bar")}) ==
        "A.N is in rpm, feed_pressure_bar in bar: another signal?");
  const std::vector<MappedSignal> both = {mapped(kFeed, "A.N", "rpm"), mapped(kRpm, "A.P", "bar")};
  CHECK(config::doubts(both).size() == 2);
}

TEST_CASE("a range inside the signal's, or none, is not doubted") {
  CHECK(doubt({mapped(kFeed, "A.P", "bar", 0, 0)}).empty());
  CHECK(doubt({mapped(kFeed, "A.P", "bar", 0, 300)}).empty());
  CHECK(doubt({mapped(kRate, "A.F", "Hz", 5, 120)}).empty());
  CHECK(doubt({mapped(kRate, "A.F", "Hz", 0, 120)}).empty());  // 0 means something there
  CHECK_FALSE(doubt({mapped(kRate, "A.F", "Hz", 1, 120)}).empty());
  CHECK_FALSE(doubt({mapped(kRods, "A.R", "", 0, 20)}).empty());
  CHECK(doubt({mapped(kRods, "A.R", "", 1, 20)}).empty());
  CHECK(doubt_scaled(mapped(kRods, "A.R", "", 0, 19), 1, 1).empty());
  CHECK(doubt_scaled(mapped(kFeed, "A.P", "", -300, 0), -1).empty());
}

TEST_CASE("a range beyond the signal's is told with what becomes of it") {
  CHECK(doubt({mapped(kFeed, "A.P", "bar", 0, 400)}) ==
        "A.P goes from 0 to 400 bar, feed_pressure_bar from 0 to 300 bar: what is above counts as 300");
  CHECK(doubt({mapped(kFeed, "A.P", "bar", -1, 300)}) ==
        "A.P goes from -1 to 300 bar, feed_pressure_bar from 0 to 300 bar: what is outside is refused");
  CHECK(doubt({mapped(kPosition, "A.X", "m", 0, 12)}) ==
        "A.X goes from 0 to 12 m, feed_position_m from 0 to 8 m: what is outside is refused");
  CHECK(doubt({mapped(kRods, "A.R", "", 0, 255)}) ==
        "A.R goes from 0 to 255, rod_count from 1 to 20: what is outside is refused");
  CHECK(doubt_scaled(mapped(kRods, "A.R", "", 0, 40), 0.5, 1) ==
        "A.R goes from 1 to 21, rod_count from 1 to 20: what is outside is refused");
}

TEST_CASE("both ends of a range are scaled and moved, and put in order") {
  CHECK(doubt_scaled(mapped(kRods, "A.R", "", 2, 9), 3, 1) ==
        "A.R goes from 7 to 28, rod_count from 1 to 20: what is outside is refused");
  CHECK(doubt_scaled(mapped(kRods, "A.R", "", 2, 9), -2, -1) ==
        "A.R goes from -19 to -5, rod_count from 1 to 20: what is outside is refused");
}

TEST_CASE("a share from 0 to 100 is one in percent") {
  CHECK(doubt({mapped(kLoad, "A.L", "", 0, 100)}) ==
        "A.L goes from 0 to 100, engine_load from 0 to 1: scale = 0.01?");
  CHECK(doubt_scaled(mapped(kLoad, "A.L", "", 0, 50), 2) ==
        "A.L goes from 0 to 100, engine_load from 0 to 1: scale = 0.02?");
  CHECK(doubt({mapped(kLoad, "A.L", "", 0, 125)}) ==
        "A.L goes from 0 to 125, engine_load from 0 to 1: what is outside is refused");
  CHECK(doubt({mapped(kLoad, "A.L", "", -1, 100)}) ==
        "A.L goes from -1 to 100, engine_load from 0 to 1: what is outside is refused");
  CHECK(doubt({mapped(Signal::kRodBroken, "A.B", "", 0, 100)}) ==
        "A.B goes from 0 to 100, rod_broken from 0 to 1: what is outside is refused");
}

TEST_CASE("two ranges that fit each the other's signal were swapped") {
  const MappedSignal feed = mapped(kFeed, "A.N", "", 0, 3000), rpm = mapped(kRpm, "A.P", "", 0, 250);
  CHECK(doubt({feed, rpm}) ==
        "A.N goes from 0 to 3000 bar, feed_pressure_bar from 0 to 300 bar: swapped with engine_rpm?");
  const std::string alone =
      "A.N goes from 0 to 3000 bar, feed_pressure_bar from 0 to 300 bar: what is above counts as 300";
  CHECK(doubt({feed}) == alone);
  CHECK(doubt({feed, mapped(kRpm, "A.N", "", 0, 250)}) == alone);   // one signal for two
  CHECK(doubt({feed, mapped(kRpm, "A.P", "")}) == alone);           // of no range
  CHECK(doubt({feed, mapped(kRpm, "A.P", "", 0, 2500)}) == alone);  // it fits where it is
  CHECK(doubt({mapped(kFeed, "A.N", "", 0, 5000), rpm}) ==
        "A.N goes from 0 to 5000 bar, feed_pressure_bar from 0 to 300 bar: what is above counts as 300");
  CHECK(doubt({mapped(kRods, "A.R", "", 1, 40), mapped(Signal::kRock, "A.K", "", 1, 9)}) ==
        "A.R goes from 1 to 40, rod_count from 1 to 20: what is outside is refused");  // numbers of no unit
}

TEST_CASE("shares in percent bring their own scale, other units none") {
  CHECK(config::scale_of_unit(kLoad, "%") == 0.01);
  CHECK(config::scale_of_unit(kLoad, "percent") == 0.01);
  CHECK(config::scale_of_unit(kLoad, "") == 1);
  CHECK(config::scale_of_unit(kLoad, "bar") == 1);
  CHECK(config::scale_of_unit(kLoad, "kPa") == 1);
  CHECK(config::scale_of_unit(kFeed, "kPa") == 1);
  CHECK(config::scale_of_unit(kFeed, "%") == 1);
  CHECK(config::scale_of_unit(kRods, "%") == 1);
}

TEST_CASE("units are known however they are written, and what each measures") {
  const auto is = [](const char* text, Quantity quantity, double factor) {
    const auto unit = config::unit_of(text);
    return unit && unit->quantity == quantity && unit->factor == doctest::Approx(factor);
  };
  CHECK(is("Bar", Quantity::kPressure, 1));
  CHECK(is("kPA", Quantity::kPressure, 0.01));
  CHECK(is("Z", Quantity::kOther, 1) == false);
  CHECK(is("R / MIN", Quantity::kFrequency, 1.0 / 60));
  CHECK(is("rad/s", Quantity::kFrequency, 1 / (2 * 3.14159265358979)));
  CHECK(
      is("\xc2\xb0"
         "C",
         Quantity::kOther, 1));
  CHECK(is("km/h", Quantity::kOther, 1));
  CHECK_FALSE(config::unit_of(""));
  CHECK_FALSE(config::unit_of("state"));
}
