// Devices as they are in the field.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "drivers/modbus/bus_harness.hpp"
#include "drivers/modbus/odd_device.hpp"
#include "modbus/client.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/modbus/probe.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

ModbusOptions asking(const OddDevice& device, int unit, std::vector<RegisterRoute> routes) {
  ModbusOptions o;
  o.role = Role::kClient;
  o.host = "127.0.0.1";
  o.port = device.port();
  o.address = "127.0.0.1:" + std::to_string(device.port());
  o.unit = unit;
  o.poll_s = 0.01;
  o.timeout_s = 0.2;
  o.routes = std::move(routes);
  return o;
}

RegisterRoute holding(Signal s, std::uint16_t address) { return route(s, Table::kHolding, address); }

Validity validity(const Told& told, Signal s) { return told.of(s).validity; }

}  // namespace

TEST_CASE("A device with holes is asked around them, and says so once") {
  OddDevice device({false, false, {{100, 90}, {106, 2}, {107, 5}}, {}, {}});
  Told told;
  Client client({asking(device, 1,
                        {holding(Signal::kFeedPressureBar, 100), holding(Signal::kRodCount, 106),
                         holding(Signal::kRock, 107), holding(Signal::kFlushing, 108)})},
                told, nullptr);
  const Running running(client);
  await([&] {
    return validity(told, Signal::kFeedPressureBar) == Validity::kValid &&
           validity(told, Signal::kRodCount) == Validity::kValid &&
           validity(told, Signal::kRock) == Validity::kValid &&
           validity(told, Signal::kFlushing) == Validity::kErrorValue;
  });
  CHECK(told.of(Signal::kFeedPressureBar).value == 90);
  CHECK(told.of(Signal::kRodCount).value == 2);
  const std::uint64_t answered = count(client, "frames_used");
  await([&] { return count(client, "frames_used") > answered + 20; });
  CHECK(told.notices() <= 4);  // two splits, the one register that is not there, once each
  CHECK(told.last_text() == "holding 108 = 40109 (1): Illegal data address");  // one unit needs no name
  CHECK(told.downs() == 0);
}

TEST_CASE("A request that was refused is split at its gaps, then value by value") {
  std::vector<RegisterRoute> routes = {holding(Signal::kFeedPressureBar, 0), holding(Signal::kRodCount, 1),
                                       holding(Signal::kRock, 4)};
  std::vector<PollRequest> plan = poll_plan(routes);
  REQUIRE(plan.size() == 1);
  REQUIRE(split(plan, plan[0], routes));
  REQUIRE(plan.size() == 2);
  CHECK((plan[0].address == 0 && plan[0].count == 2 && plan[1].address == 4 && plan[1].count == 1));
  REQUIRE(split(plan, plan[0], routes));
  REQUIRE(plan.size() == 3);
  CHECK((plan[1].address == 1 && plan[1].count == 1));
  CHECK_FALSE(split(plan, plan[1], routes));
  CHECK(plan.size() == 3);
}

TEST_CASE("A device that closes after each answer delivers everything, without a word and without a loss") {
  OddDevice device({true, false, {{100, 90}, {200, 55}, {300, 3}}, {}, {}});
  Told told;
  Client client({asking(device, 1,
                        {holding(Signal::kFeedPressureBar, 100), holding(Signal::kRotationPressureBar, 200),
                         holding(Signal::kRodCount, 300)})},
                told, nullptr);
  const Running running(client);
  await([&] { return count(client, "frames_used") >= 60; });
  CHECK(told.of(Signal::kFeedPressureBar).value == 90);
  CHECK(told.of(Signal::kRotationPressureBar).value == 55);
  CHECK(told.of(Signal::kRodCount).value == 3);
  CHECK(told.ups() == 1);
  CHECK(told.downs() == 0);
  CHECK(told.notices() == 0);
  CHECK(count(client, "losses") == 0);
  CHECK(device.connections() >= 60);
}

TEST_CASE(
    "Units behind one gateway are asked in turn over one connection; one that is silent harms no other") {
  OddDevice device({false, false, {{0, 77}}, {2}, {3}});
  std::vector<ModbusOptions> sections = {asking(device, 1, {holding(Signal::kFeedPressureBar, 0)}),
                                         asking(device, 2, {holding(Signal::kRotationPressureBar, 0)}),
                                         asking(device, 3, {holding(Signal::kRodCount, 0)}),
                                         asking(device, 4, {holding(Signal::kRock, 0)})};
  const std::vector<modbus::Line> all = lines(sections);
  REQUIRE(all.size() == 1);
  Told told;
  const auto client = make_bus(all[0], told);
  CHECK(client->signals().size() == 4);
  const Running running(*client);
  await([&] { return validity(told, Signal::kRock) == Validity::kValid && device.requests(2) >= 3; });
  CHECK(told.of(Signal::kFeedPressureBar).value == 77);
  CHECK(validity(told, Signal::kRotationPressureBar) == Validity::kNeverSeen);
  CHECK(validity(told, Signal::kRodCount) == Validity::kErrorValue);
  CHECK(told.ups() == 1);
  CHECK(told.downs() == 0);
  await([&] { return device.requests(1) >= 5 * device.requests(2); });  // nobody waits for it each time
}

TEST_CASE("A unit whose neighbours answer is down when it was silent too long") {
  auto device = std::make_unique<OddDevice>(Moods{false, false, {{0, 77}}, {}, {}});
  const int port = device->port();
  modbus::Line line = {asking(*device, 1, {holding(Signal::kFeedPressureBar, 0)}),
                       asking(*device, 2, {holding(Signal::kRotationPressureBar, 0)})};
  for (ModbusOptions& unit : line) unit.down_after_s = 2;  // longer than the device is away
  Told told;
  Client client(line, told, nullptr);
  const Running running(client);
  await([&] { return validity(told, Signal::kRotationPressureBar) == Validity::kValid; });
  device.reset();
  device = std::make_unique<OddDevice>(Moods{false, false, {{0, 77}}, {2}, {}}, port);
  await([&] { return validity(told, Signal::kRotationPressureBar) == Validity::kBusDown; });
  await([&] { return validity(told, Signal::kFeedPressureBar) == Validity::kValid; });
}

TEST_CASE("Two units on one serial line are asked in turn by one master") {
  SerialLine pty;
  ModbusOptions first;
  first.role = Role::kClient;
  first.transport = Transport::kRtu;
  first.address = pty.device();
  first.unit = 1;
  first.poll_s = 0.01;
  first.timeout_s = 60;
  first.routes = {holding(Signal::kFeedPressureBar, 0)};
  ModbusOptions second = first;
  second.unit = 2;
  second.routes = {holding(Signal::kRotationPressureBar, 0)};
  Told told;
  const auto client = make_bus(lines({first, second}).at(0), told);
  const Running running(*client);
  int asked[3] = {};
  while (asked[1] < 3 || asked[2] < 3) {
    const Bytes question = pty.hear(8);  // one at a time: the other would be mixed in
    const std::uint8_t unit = question[0];
    REQUIRE((unit == 1 || unit == 2));
    REQUIRE(question == with_checksum({unit, 3, 0, 0, 0, 1}));
    ++asked[unit];
    pty.say(with_checksum({unit, 3, 2, 0, static_cast<std::uint8_t>(50 + unit)}));
  }
  CHECK(std::abs(asked[1] - asked[2]) <= 3);
  await([&] { return told.total() >= 6; });
  CHECK(told.of(Signal::kFeedPressureBar).value == 51);
  CHECK(told.of(Signal::kRotationPressureBar).value == 52);
  pty.cut();
}

TEST_CASE("RTU frames over TCP") {
  OddDevice device({false, true, {{0, 90}}, {}, {}});
  ModbusOptions options = asking(device, 7, {holding(Signal::kFeedPressureBar, 0)});
  options.transport = Transport::kRtuTcp;
  Told told;
  Client client({options}, told, nullptr);
  const Running running(client);
  await([&] { return validity(told, Signal::kFeedPressureBar) == Validity::kValid; });
  CHECK(told.of(Signal::kFeedPressureBar).value == 90);
  CHECK(device.requests(7) >= 1);
}

TEST_CASE("Pauses are kept after connecting and between requests") {
  OddDevice device({false, false, {{0, 1}, {100, 2}}, {}, {}});
  ModbusOptions options =
      asking(device, 1, {holding(Signal::kFeedPressureBar, 0), holding(Signal::kRodCount, 100)});
  options.pause_s = 0.05;
  Told told;
  Client client({options}, told, nullptr);
  const auto start = std::chrono::steady_clock::now();
  while (told.total() < 4) client.step();
  CHECK(std::chrono::steady_clock::now() - start >=
        std::chrono::milliseconds(4 * 49));  // kept to the millisecond
}

TEST_CASE("A probe reads each signal by itself, or says why it cannot be read") {
  OddDevice device({true, false, {{100, 90}, {106, 2}}, {}, {}});
  const ModbusOptions options = asking(
      device, 1,
      {holding(Signal::kFeedPressureBar, 100), holding(Signal::kRock, 103), holding(Signal::kRodCount, 106)});
  const std::vector<Probed> found = probe(options);
  REQUIRE(found.size() == 3);
  CHECK(found[0].words == std::vector<std::uint16_t>{90});
  CHECK(found[1].words.empty());
  CHECK(found[1].problem == "Illegal data address");
  CHECK(found[2].words == std::vector<std::uint16_t>{2});
}

TEST_CASE("A probe keeps its connection to a device that keeps it, and asks for each signal once") {
  OddDevice device({false, false, {{100, 90}, {106, 2}}, {}, {}});
  probe(asking(device, 1,
               {holding(Signal::kFeedPressureBar, 100), holding(Signal::kRock, 103),
                holding(Signal::kRodCount, 106)}));
  CHECK(device.connections() == 1);
  CHECK(device.requests(1) == 3);
}
