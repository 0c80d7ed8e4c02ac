// A real port on loopback, and senders that mean well, badly, or nothing.
#include "udp/udp_bus.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "drivers/modbus/bus_harness.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/udp/udp_sender.hpp"

using namespace rigsound;
using namespace rigsound::udp;
using modbus::await;
using modbus::count;
using modbus::Running;
using modbus::Told;

namespace {

std::vector<NameRoute> routes() {
  return {{{Signal::kEngineRpm, 0}, "engine_rpm", ""},
          {{Signal::kPercussion, 0}, "percussion", "boom1.percussion"},
          {{Signal::kRattling, 0}, "rattling", "boom1.rattling"},
          {{Signal::kRattling, 1}, "boom2.rattling", ""},
          {{Signal::kFeedPressureBar, 1}, "boom2.feed_pressure_bar", ""}};
}

/// `engine_rpm 1500; boom2.rattling 1`, or `! why not`.
std::string read_datagram(const std::string& text) {
  std::string problem, told;
  const auto content = DatagramReader(routes()).read(text, 1, problem);
  if (!content) return "! " + problem;
  for (const Reading& reading : content->readings) {
    told += std::string(told.empty() ? "" : "; ") + (reading.id.boom == 1 ? "boom2." : "") +
            std::string(info(reading.id.signal).name) + " ";
    told += reading.validity != Validity::kValid ? std::string(name(reading.validity))
                                                 : number_text(reading.value);
  }
  if (content->sequence) told += " seq " + std::to_string(*content->sequence);
  if (content->unknown_count > 0) told += " unknown " + content->unknown;
  return told;
}

struct ListeningUdp {
  explicit ListeningUdp(std::vector<Network> allow = {}) {
    options.host = "127.0.0.1";
    options.port = 0;
    options.allow = std::move(allow);
    options.routes = routes();
    bus = std::make_unique<UdpBus>(options, told, nullptr);
    bus->step();
    REQUIRE(bus->port() != 0);
    sender = std::make_unique<UdpSender>("127.0.0.1:" + std::to_string(bus->port()));
    running = std::make_unique<Running>(*bus);
  }

  UdpOptions options;
  Told told;
  std::unique_ptr<UdpBus> bus;
  std::unique_ptr<UdpSender> sender;
  std::unique_ptr<Running> running;
};

}  // namespace

TEST_CASE("A datagram names signals and says their values, in every way people write them") {
  CHECK(read_datagram(R"({"engine_rpm": 1500, "boom2.rattling": 1})") == "engine_rpm 1500; boom2.rattling 1");
  CHECK(read_datagram(R"({"boom2": {"rattling": "open", "feed_pressure_bar": 90.5}, "engine_rpm": 1e3})") ==
        "boom2.rattling 2; boom2.feed_pressure_bar 90.5; engine_rpm 1000");
  CHECK(read_datagram(R"({"percussion": true, "rattling": "none"})") == "percussion 1; rattling 0");
  CHECK(read_datagram(R"({"boom1": {"percussion": 1}, "boom1.rattling": 2})") == "percussion 1; rattling 2");
  CHECK(read_datagram(R"({"percussion": null})") == "percussion not_available");
  CHECK(read_datagram(R"({"seq": 7, "percussion": false})") == "percussion 0 seq 7");
  CHECK(read_datagram(R"({"engine_rmp": 1, "percussion": 1})") == "percussion 1 unknown engine_rmp");
  CHECK(read_datagram(R"({"boom3": {"rattling": 1}})") == " unknown boom3.rattling");
  CHECK(read_datagram("{}") == "");
}

TEST_CASE("A datagram counts whole or not at all") {
  for (const char* text :
       {"", " ", "x", "1", "[]", "\"engine_rpm\"", "null", R"({"engine_rpm": 1500)", R"({"engine_rpm": [1]})",
        R"({"engine_rpm": 1500} x)", R"({"boom2": {"rattling": {"a": 1}}})", R"({"engine_rpm": 01})",
        R"({"engine_rpm": NaN})", "{\"engine_rpm\": 1\0}", "\xff\xfe{"}) {
    CAPTURE(text);
    CHECK(read_datagram(text).rfind("! ", 0) == 0);
  }
  CHECK(read_datagram(std::string(100000, '[')) == "! a list");
  CHECK(read_datagram(std::string(50000, '{')).rfind("! ", 0) == 0);
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += "{\"a\":";
  CHECK(read_datagram(deep) == "! an object in a boom's object");
}

TEST_CASE("A word that a signal does not have, or a number out of its range, is refused by the board") {
  SignalBoard board;
  std::string problem;
  const auto content = DatagramReader(routes()).read(
      R"({"rattling": "opn", "engine_rpm": 1e300, "percussion": 2, "boom2.rattling": -1})", 1, problem);
  REQUIRE(content);
  REQUIRE(content->readings.size() == 4);
  for (const Reading& reading : content->readings) CHECK(board.take(reading) == Validity::kOutOfRange);
}

TEST_CASE("Numbers tell a late datagram from a sender that began anew") {
  SequenceFilter filter;
  CHECK(filter.passes(10, 0));
  CHECK(filter.passes(12, 0.1));
  CHECK_FALSE(filter.passes(11, 0.2));
  CHECK_FALSE(filter.passes(12, 0.2));
  CHECK(filter.passes(13, 0.3));
  CHECK(filter.passes(0, 2));  // after a pause
  CHECK(filter.passes(5000, 2.1));
  CHECK(filter.passes(1, 2.2));  // far behind
  for (const auto& [behind, later_s, good] :
       {std::tuple(999, 0.5, false), std::tuple(1000, 0.5, true), std::tuple(5, 0.75, false),
        std::tuple(5, 1.0, true), std::tuple(0, 0.0, false)}) {
    SequenceFilter edge;
    CHECK(edge.passes(7000, 4));
    CHECK(edge.passes(7000 - behind, 4 + later_s) == good);
  }
}

TEST_CASE("What is sent is told with its time, and counted") {
  ListeningUdp l;
  REQUIRE(l.sender->send(R"({"engine_rpm": 1500, "boom2": {"feed_pressure_bar": 90}})"));
  await([&] { return l.told.of(Signal::kFeedPressureBar).value == 90; });
  CHECK(l.told.of(Signal::kEngineRpm).value == 1500);
  CHECK(l.told.of(Signal::kEngineRpm).time_s > 0);
  CHECK(l.told.ups() == 1);
  REQUIRE(l.sender->send("not JSON"));
  REQUIRE(l.sender->send(std::string(kLongestDatagram + 1, ' ')));
  REQUIRE(l.sender->send(R"({"seq": 5, "engine_rpm": 1501})"));
  REQUIRE(l.sender->send(R"({"seq": 4, "engine_rpm": 1502})"));
  await([&] { return count(*l.bus, "frames_seen") == 5; });
  CHECK(count(*l.bus, "frames_bad") == 2);
  CHECK(count(*l.bus, "frames_late") == 1);
  CHECK(count(*l.bus, "frames_used") == 2);
  CHECK(l.told.of(Signal::kEngineRpm).value == 1501);
}

TEST_CASE("Only allowed networks may send") {
  ListeningUdp l({{"10.0.0.0/8", {10, 0, 0, 0}, 8}});
  REQUIRE(l.sender->send(R"({"engine_rpm": 1500})"));
  await([&] { return l.told.notices() == 1; });
  CHECK(count(*l.bus, "frames_rejected") == 1);
  CHECK(l.told.total() == 0);
}

TEST_CASE("A flood of garbage changes nothing but counters, in one line") {
  ListeningUdp l;
  REQUIRE(l.sender->send(R"({"engine_rpm": 1500})"));
  await([&] { return l.told.of(Signal::kEngineRpm).value == 1500; });
  const std::size_t before = l.told.total();
  for (int i = 0; i < 20000; ++i) l.sender->send(std::string(static_cast<std::size_t>(i % 300), '{'));
  await([&] {
    l.sender->send(R"({"engine_rpm": 1600})");
    return l.told.of(Signal::kEngineRpm).value == 1600;
  });
  CHECK(l.told.total() > before);
  CHECK(count(*l.bus, "frames_bad") > 0);
  CHECK(l.told.notices() == 1);
}

TEST_CASE("A port that is taken is told, and tried again") {
  ListeningUdp l;
  UdpOptions other = l.options;
  other.port = l.bus->port();
  Told told;
  UdpBus second(other, told, nullptr);
  second.step();
  second.step();
  CHECK(told.ups() == 0);
  CHECK(told.notices() == 1);
}
