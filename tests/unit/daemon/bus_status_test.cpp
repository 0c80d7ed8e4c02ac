// What is known of a bus: up or down, why, and nothing twice.
#include "bus_status.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "daemon/kept_log.hpp"
#include "rigsound/monotonic_time.hpp"

using rigsound::monotonic_ms;
using rigsound::daemon::BusStatus;
using rigsound::test::KeptLog;

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

TEST_CASE("a bus tells a change at once, then one line a minute with how often it changed meanwhile") {
  using Lines = std::vector<std::string>;
  const KeptLog log;
  BusStatus bus("can can0");
  bus.poll(monotonic_ms());
  CHECK(log.lines().empty());  // nothing has changed
  const std::int64_t before_ms = monotonic_ms();
  bus.up();
  const std::int64_t after_ms = monotonic_ms();
  Lines expected = {"info: can can0: up"};
  CHECK(log.lines() == expected);
  bus.down("bus-off");
  bus.up();
  bus.down("can can0: no such device");
  bus.poll(before_ms + 59'999);
  CHECK(log.lines() == expected);
  const std::int64_t told_ms = after_ms + 60'000;
  bus.poll(told_ms);
  expected.push_back("warning: can can0: down: no such device (after 3 changes)");
  CHECK(log.lines() == expected);
  bus.up();
  bus.poll(told_ms + 59'999);
  CHECK(log.lines() == expected);
  bus.poll(told_ms + 60'000);
  expected.push_back("info: can can0: up");
  CHECK(log.lines() == expected);
  bus.poll(told_ms + 600'000);
  CHECK(log.lines() == expected);
}

TEST_CASE("a notice is told at once, with the name of its bus once") {
  const KeptLog log;
  BusStatus bus("udp :9");
  bus.notice("udp :9: port in use");
  bus.notice("a datagram was no JSON");
  CHECK(log.lines() ==
        std::vector<std::string>{"warning: udp :9: port in use", "warning: udp :9: a datagram was no JSON"});
}
