// What a user is told of a log in which the rig finds nothing: the nearest thing that it holds.
#include "log/can_survey.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

using namespace rigsound;
using namespace rigsound::log;

namespace {

CanRecord record(std::uint32_t id, std::initializer_list<int> bytes, const char* interface = "can0") {
  CanRecord r;
  r.interface = interface;
  r.frame.id = id;
  r.frame.extended = id > can::kMaxStandardId;
  for (const int b : bytes) r.frame.data[r.frame.size++] = static_cast<std::uint8_t>(b);
  return r;
}

can::SignalRoute route(Signal signal, const char* name, can::MessageMatch match) {
  can::SignalRoute r;
  r.target = {signal};
  r.name = name;
  r.match = match;
  r.layout.field = {0, 8, can::ByteOrder::kIntel};
  r.layout.scale = 2;
  return r;
}

constexpr can::MessageMatch kFeed{0x123, false, false, {}}, kEec1{0x0CF00421, true, true, 0x21},
    kOwn{0x18FF2005, true, false, {}};

can::CanOptions bus_of(std::initializer_list<can::SignalRoute> routes) {
  can::CanOptions bus;
  bus.interface = "can0";
  bus.routes = routes;
  return bus;
}

const can::CanOptions kBus =
    bus_of({route(Signal::kFeedPositionM, "Boom.Feed", kFeed), route(Signal::kEngineRpm, "EEC1.Speed", kEec1),
            route(Signal::kRodCount, "Own.Rods", kOwn)});

std::string nearest_of(std::initializer_list<CanRecord> records, const can::CanOptions& bus = kBus) {
  CanSurvey survey({bus});
  for (const CanRecord& r : records) CHECK_FALSE(survey.add(bus, r));
  CHECK(survey.frames() == records.size());
  return survey.nearest();
}

}  // namespace

TEST_CASE("A frame with a value for the rig ends the survey") {
  CanSurvey survey({kBus});
  CHECK_FALSE(survey.add(kBus, record(0x124, {10})));
  CHECK(survey.add(kBus, record(0x123, {3})));
  CHECK(survey.add(kBus, record(0x18F00421, {10})));  // J1939: another priority
  CHECK(survey.add(kBus, record(0x18FF2005, {3})));
  CHECK(survey.frames() == 4);
}

TEST_CASE("A value beyond its signal's range is told with both") {
  CHECK(nearest_of({record(0x123, {200})}) ==
        "Boom.Feed is 400, but feed_position_m goes from 0 to 8: another scale?");
  CHECK(nearest_of({record(0x123, {200}), record(0x123, {201})}) ==
        "Boom.Feed is 400, but feed_position_m goes from 0 to 8: another scale?");
}

TEST_CASE("A message without a value is told, be it too short or not available") {
  CHECK(nearest_of({record(0x0CF00421, {0xff})}) == "EEC1.Speed has no value: not_available");
  CHECK(nearest_of({record(0x123, {})}) == "Boom.Feed has no value: not_available");
}

TEST_CASE("CAN FD frames of the rig's messages are of use only where the rig takes them") {
  CanRecord fd = record(0x123, {3});
  fd.frame.fd = true;
  CHECK(nearest_of({fd}) == "the rig's messages came as CAN FD frames: fd = true?");
  can::CanOptions takes = kBus;
  takes.fd = true;
  CHECK(CanSurvey({takes}).add(takes, fd));
}

TEST_CASE(
    "A J1939 message of another source is told with both addresses, or with j1939 where that is meant") {
  CHECK(nearest_of({record(0x0CF00403, {10})}) ==
        "EEC1 (PGN 61444) came from 03, the rig says source = 0x21");
  CHECK(nearest_of({record(0x18FF2017, {10})}) == "PGN 65312 came from 17, the DBC says 05: j1939 = true?");
}

TEST_CASE("An identifier of the other length is told with both lengths") {
  CanRecord long_one = record(0x123, {3});
  long_one.frame.extended = true;
  CHECK(nearest_of({long_one}) == "Boom is an identifier of 11 bits, but came with 29");
  const can::CanOptions bus =
      bus_of({route(Signal::kRodCount, "Own.Rods", can::MessageMatch{0x55, true, false, {}})});
  CHECK(nearest_of({record(0x55, {3})}, bus) == "Own is an identifier of 29 bits, but came with 11");
}

TEST_CASE("A message announced by J1939's transport protocol is told as such, others' are not") {
  const auto announced = [](int control, int low, int middle, int high) {
    return record(0x1CECFF21, {control, 9, 0, 2, 0xff, low, middle, high});
  };
  const std::string said =
      "EEC1 (PGN 61444) comes by transport protocol (PGN 60416 and 60160), which is not read";
  CHECK(nearest_of({announced(32, 0x04, 0xf0, 0)}) == said);
  CHECK(nearest_of({announced(16, 0x04, 0xf0, 0)}) == said);
  const std::string none = "it holds 1CECFF21, the rig wants Boom = 123, EEC1 = 0CF00421, Own = 18FF2005";
  CHECK(nearest_of({announced(17, 0x04, 0xf0, 0)}) == none);  // clear to send
  CHECK(nearest_of({announced(32, 0x05, 0xf0, 0)}) == none);
  CHECK(nearest_of({announced(32, 0x04, 0xf1, 0)}) == none);
  CHECK(nearest_of({announced(32, 0x04, 0xf0, 1)}) == none);
  CHECK(nearest_of({record(0x1CECFF21, {32, 9, 0, 2, 0xff, 0x04, 0xf0})}) == none);
}

TEST_CASE("A message on an interface that is none of the rig's is told with both") {
  CanSurvey survey({kBus});
  survey.add_foreign(record(0x124, {10}, "can3"));
  CHECK(survey.nearest() ==
        "it holds no data frame of the rig's interfaces, the rig wants Boom = 123, EEC1 = 0CF00421, Own = "
        "18FF2005");
  survey.add_foreign(record(0x123, {3}, "can3"));
  CHECK(survey.nearest() == "Boom came on can3, the rig wants it on can0: --can can3=can0?");
  CHECK(survey.frames() == 2);
}

TEST_CASE("Without anything near, the five most frequent identifiers are told, and each message once") {
  const can::CanOptions bus = bus_of(
      {route(Signal::kFeedPositionM, "Boom.Feed", kFeed), route(Signal::kRodCount, "Boom.Rods", kFeed)});
  CanRecord remote = record(0x700, {}), error = record(0x701, {});
  remote.frame.remote = true;
  error.frame.error = true;
  CHECK(nearest_of({record(1, {}), record(2, {}), record(2, {}), record(3, {}), record(4, {}), record(5, {}),
                    record(5, {}), record(5, {}), remote, error},
                   bus) == "it holds 005, 002, 001, 003, 004, the rig wants Boom = 123");
  CHECK(nearest_of({record(0x11, {}), record(0x12, {}), record(0x13, {}), record(0x14, {}), record(0x15, {}),
                    record(0x16, {}), record(0x17, {})},
                   bus) == "it holds 011, 012, 013, 014, 015 and 2 more, the rig wants Boom = 123");
}
