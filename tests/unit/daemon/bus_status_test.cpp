// What is known of a bus: up or down, why, and nothing twice.
#include "bus_status.hpp"

#include <doctest/doctest.h>

using rigsound::daemon::BusStatus;

TEST_CASE("a bus is down until it is up, and clears its problem then") {
  BusStatus bus("can can0");
  CHECK(bus.name() == "can can0");
  CHECK_FALSE(bus.is_up());
  CHECK(bus.last_problem().empty());
  bus.down("can can0: no such device");
  CHECK_FALSE(bus.is_up());
  CHECK(bus.last_problem() == "no such device");  // the name is known already
  bus.up();
  CHECK(bus.is_up());
  CHECK(bus.last_problem().empty());
  bus.down("network is down");
  CHECK_FALSE(bus.is_up());
  CHECK(bus.last_problem() == "network is down");
}

TEST_CASE("a notice is the problem of a bus that is down, and only a remark on one that is up") {
  BusStatus bus("udp :9");
  bus.notice("udp :9: port in use");
  CHECK(bus.last_problem() == "port in use");
  bus.up();
  bus.notice("a datagram was no JSON");
  CHECK(bus.is_up());
  CHECK(bus.last_problem().empty());
}

TEST_CASE("a name inside a text, or without its colon, stays") {
  BusStatus bus("a");
  bus.down("a: a: b");
  CHECK(bus.last_problem() == "a: b");
  bus.down("a b");
  CHECK(bus.last_problem() == "a b");
  bus.down("b a: c");
  CHECK(bus.last_problem() == "b a: c");
}
