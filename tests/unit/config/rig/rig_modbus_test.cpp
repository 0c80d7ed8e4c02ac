// The Modbus buses of a rig.
#include <doctest/doctest.h>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

std::string section(const std::string& keys, const std::string& signals) {
  return "[[modbus]]\n" + keys + "[modbus.signals]\n" + signals;
}
const char* const kFeedAt0 = "feed_pressure_bar = { address = 0 }\n";
const char* const kRodsAt0 = "rod_count = { address = 0 }\n";

modbus::RegisterRoute route_of(const std::string& signal) {
  return loaded(section("role = \"client\"\n", signal + "\n")).modbus.at(0).routes.at(0);
}

}  // namespace

TEST_CASE("Modbus registers are checked") {
  const auto said = [](const std::string& entry) {
    return refusal("[[modbus]]\n[modbus.signals]\nrock = " + entry + "\n");
  };
  CHECK(said("{ table = \"holding\" }") ==
        ":3: modbus.signals.rock.address: is missing, expected a register or bit counted from 0");
  CHECK(said("{ address = 65536 }") == ":3: modbus.signals.rock.address: is 65536, expected 0...65535");
  CHECK(said("{ address = 65535, type = \"float32\" }").find("expected at most 65534") != std::string::npos);
  CHECK(said("{ address = 0, table = \"coil\", type = \"int16\" }").find("does not go with a bit") !=
        std::string::npos);
  CHECK(said("{ address = 0, scale = 0 }").find("is 0, expected any other number") != std::string::npos);
  CHECK(refusal("[[modbus]]\nallow = [\"10.0.0.1/8\"]\n").find("is no network") != std::string::npos);
  CHECK(refusal("[[modbus]]\nunit = 250\n").find("is no unit") != std::string::npos);
  CHECK(refusal("[[modbus]]\ntransport = \"rtu\"\n").find("modbus.address: is missing") != std::string::npos);
}

TEST_CASE("bits, masks and tables of values of a Modbus register") {
  CHECK(route_of("percussion = { address = 0, bit = 3 }").mask == 8);
  CHECK(route_of("rod_count = { address = 0, mask = 0xF00 }").mask == 0xF00);
  CHECK(route_of("rod_count = { address = 0, type = \"uint32\", mask = 4294967295 }").mask == 0xFFFFFFFF);
  const auto rattling =
      route_of("rattling = { address = 0, values = { 0 = \"none\", 3 = \"open\", 7 = 1 } }");
  REQUIRE(rattling.values.size() == 3);
  CHECK((rattling.values[1].raw == 3 && rattling.values[1].value == 2));
  CHECK((rattling.values[2].raw == 7 && rattling.values[2].value == 1));
  const auto refused = [](const std::string& signal) { return refusal(section("", signal + "\n")); };
  CHECK(refused("percussion = { address = 0, bit = 3, mask = 8 }").find("expected one of them") !=
        std::string::npos);
  CHECK(refused("percussion = { address = 0, bit = 32 }").find("0...31") != std::string::npos);
  CHECK(refused("percussion = { table = \"coil\", address = 0, bit = 3 }").find("does not go with a bit") !=
        std::string::npos);
  CHECK(refused("feed_pressure_bar = { address = 0, type = \"float32\", mask = 3 }")
            .find("does not go with a float") != std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { 0 = \"nun\" } }")
            .find("expected one of none,closed,open") != std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { a = \"none\" } }").find("is no raw value") !=
        std::string::npos);
  CHECK(refused("rattling = { address = 0, values = { 0 = 9 } }").find("0...2") != std::string::npos);
  CHECK(
      refused("rattling = { address = 0, scale = 2, values = { 0 = 1 } }").find("does not go with values") !=
      std::string::npos);
  CHECK(refused("feed_pressure_bar = { address = 65533, type = \"float64\" }").find("at most 65532") !=
        std::string::npos);
}

TEST_CASE("what cannot share a line or a port is refused, what can becomes one line") {
  const auto both = [](const std::string& a, const std::string& b) {
    return refusal(section(a, kFeedAt0) + section(b, kRodsAt0));
  };
  const std::string server = "address = \"127.0.0.1:1502\"\n", client = "role = \"client\"\n" + server;
  CHECK(both(server, server + "unit = 2\n").find("is a port that two servers listen at") !=
        std::string::npos);
  CHECK(
      both(server, "address = \"0.0.0.0:1502\"\nallow = [\"10.0.0.0/8\"]\n").find("two servers listen at") !=
      std::string::npos);
  CHECK(both(server, client) == "");  // one asks what the other serves
  CHECK(both(client + "unit = 1\n", client + "unit = 2\n") == "");
  CHECK(both(client, client + "transport = \"rtu_tcp\"\nunit = 2\n").find("expected the same transport") !=
        std::string::npos);
  const std::string line = "transport = \"rtu\"\naddress = \"/dev/ttyS77\"\n";
  CHECK(both("role = \"client\"\n" + line, "role = \"client\"\nunit = 2\n" + line) == "");
  CHECK(both("role = \"client\"\n" + line, "role = \"client\"\nbaud = 9600\n" + line)
            .find("the same transport, baud") != std::string::npos);
  CHECK(both(line, "role = \"client\"\n" + line).find("on a line with a server") != std::string::npos);
  const config::Rig rig =
      loaded(section(client + "unit = 1\n", kFeedAt0) + section(client + "unit = 2\n", kRodsAt0));
  CHECK(rig.modbus.size() == 2);
}

TEST_CASE("units, manuals' numbers and servers that hear nobody") {
  CHECK(refusal(section("unit = 0\n", kFeedAt0)) == "");
  CHECK(refusal(section("transport = \"rtu\"\naddress = \"/dev/ttyS77\"\nunit = 0\n", kFeedAt0))
            .find("0 is a broadcast on RTU") != std::string::npos);
  CHECK(refusal(section("unit = 248\n", kFeedAt0)).find("0 or 255 on TCP") != std::string::npos);
  const auto doubts = [](const std::string& keys, const std::string& signals) {
    const config::Rig rig = loaded(section(keys, signals));
    return rig.doubts.empty() ? std::string() : rig.doubts.front();
  };
  CHECK(doubts("", "feed_pressure_bar = { address = 40001 }\n")
            .find("address 40001 counts from 0, so it is holding 40001 = 80002: address = 0?") !=
        std::string::npos);
  CHECK(doubts("", "feed_pressure_bar = { table = \"input\", address = 30011 }\n").find("address = 10?") !=
        std::string::npos);
  CHECK(doubts("", "feed_pressure_bar = { address = 39999 }\n") == "");
  CHECK(doubts("address = \"0.0.0.0:502\"\n", kFeedAt0).find("only this machine may connect") !=
        std::string::npos);
  CHECK(doubts("address = \"0.0.0.0:502\"\nallow = [\"10.0.0.0/8\"]\n", kFeedAt0) == "");
}

TEST_CASE("a unit is down when the last of its signals is stale") {
  const config::Rig rig = loaded(
      "[safety]\nrod_count = { stale_after_ms = 5000 }\n" +
      section("role = \"client\"\npoll_ms = 20\n", std::string(kFeedAt0) + "rod_count = { address = 1 }\n"));
  CHECK(rig.modbus[0].down_after_s == 5);
  CHECK(loaded(section("role = \"client\"\npoll_ms = 1000\n", kFeedAt0)).modbus[0].down_after_s == 3);
  CHECK(loaded(section("role = \"client\"\npoll_ms = 2000\n", kFeedAt0)).modbus[0].down_after_s == 6);
}
