// The numbers of a [[modbus]] section: the last that is taken, and one beyond.
#include <doctest/doctest.h>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

std::string said_of_link(const std::string& keys) { return refusal("[[modbus]]\n" + keys); }

std::string said_of_register(const std::string& route, const std::string& signal = "feed_pressure_bar") {
  return refusal("[[modbus]]\n[modbus.signals]\n" + signal + " = { " + route + " }\n");
}

/// What is doubted of a link with these keys and one register, behind its place; empty: nothing.
std::string doubt_of_link(const std::string& keys, const std::string& route = "address = 0") {
  const config::Rig rig =
      loaded("[[modbus]]\n" + keys + "[modbus.signals]\nfeed_pressure_bar = { " + route + " }\n");
  return rig.doubts.empty() ? std::string() : rig.doubts.front();
}

const std::string kRtuKeys = "transport = \"rtu\"\naddress = \"/dev/ttyS77\"\n";

}  // namespace

TEST_CASE("registers end at 65535, also those that take more than one") {
  CHECK(said_of_register("address = 65535").empty());
  CHECK(said_of_register("address = 65535, type = \"int16\"").empty());
  CHECK(said_of_register("address = 65534, type = \"float32\"").empty());
  CHECK(said_of_register("address = 65532, type = \"float64\"").empty());
  CHECK(said_of_register("address = 65535, type = \"uint32\"") ==
        ":3: modbus.signals.feed_pressure_bar.address: leaves no room for its registers, expected at most "
        "65534");
  CHECK(said_of_register("address = 65533, type = \"float64\"") ==
        ":3: modbus.signals.feed_pressure_bar.address: leaves no room for its registers, expected at most "
        "65532");
}

TEST_CASE("units are 1 to 247; on TCP 0 and 255 are there, too") {
  const std::string beyond = "is no unit, expected 1 to 247, or 0 or 255 on TCP";
  for (const char* unit : {"0", "1", "247", "255"})
    CHECK(said_of_link("unit = " + std::string(unit) + "\n").empty());
  for (const char* unit : {"248", "254"})
    CHECK(said_of_link("unit = " + std::string(unit) + "\n") ==
          ":2: modbus.unit: " + std::string(unit) + " " + beyond);
  for (const std::string& frames : {kRtuKeys, std::string("transport = \"rtu_tcp\"\n")}) {
    CAPTURE(frames);
    CHECK(said_of_link(frames + "unit = 1\n").empty());
    CHECK(said_of_link(frames + "unit = 247\n").empty());
    CHECK(said_of_link(frames + "unit = 248\n").find("modbus.unit: 248 " + beyond) != std::string::npos);
    CHECK(said_of_link(frames + "unit = 255\n").find("modbus.unit: 255 " + beyond) != std::string::npos);
    CHECK(said_of_link(frames + "unit = 0\n").find("modbus.unit: 0 is a broadcast on RTU") !=
          std::string::npos);
    CHECK(loaded("[[modbus]]\n" + frames).modbus[0].unit == 1);
  }
}

TEST_CASE("raw values of a table are whole numbers") {
  CHECK(said_of_register("address = 0, values = { -1 = \"none\", 65535 = \"open\" }", "rattling").empty());
  for (const char* raw : {"a", "1a", "99999999999999999999"}) {
    CAPTURE(raw);
    CHECK(said_of_register("address = 0, values = { " + std::string(raw) + " = \"none\" }", "rattling") ==
          ":3: modbus.signals.rattling.values." + std::string(raw) +
              ": is no raw value, expected a whole number");
  }
  CHECK(said_of_register("address = 0, offset = 1, values = { 0 = 1 }", "rattling")
            .find("rattling.offset: does not go with values") != std::string::npos);
}

TEST_CASE("a table of values holds what its signal may be: 0 where that means something, else its range") {
  CHECK(said_of_register("address = 0, values = { 0 = 0, 1 = 40 }", "percussion_rate_hz").empty());
  CHECK_FALSE(said_of_register("address = 0, values = { 0 = 1 }", "percussion_rate_hz").empty());
  CHECK(said_of_register("address = 0, values = { 0 = 1, 1 = 20 }", "rod_count").empty());
  CHECK_FALSE(said_of_register("address = 0, values = { 0 = 0 }", "rod_count").empty());
  CHECK_FALSE(said_of_register("address = 0, values = { 0 = 21 }", "rod_count").empty());
}

TEST_CASE("a unit is down after its time-out or three polls, whichever is longer, and not before 0.3 s") {
  const auto down_after_s = [](const std::string& keys) {
    return loaded("[[modbus]]\nrole = \"client\"\n" + keys).modbus[0].down_after_s;
  };
  CHECK(down_after_s("poll_ms = 100\ntimeout_ms = 2000\n") == 2);
  CHECK(down_after_s("poll_ms = 1000\ntimeout_ms = 500\n") == 3);
  CHECK(down_after_s("poll_ms = 20\ntimeout_ms = 100\n") == 0.3);
}

TEST_CASE("a bit is one of 32, and no mask and no float beside it") {
  CHECK(said_of_register("address = 0, type = \"uint32\", bit = 31", "percussion").empty());
  CHECK(said_of_register("address = 0, type = \"float32\", bit = 3")
            .find("feed_pressure_bar.bit: does not go with a float") != std::string::npos);
  CHECK(said_of_register("address = 0, type = \"float64\", mask = 3")
            .find("feed_pressure_bar.mask: does not go with a float") != std::string::npos);
}

TEST_CASE("keys of a serial line are for a serial line") {
  for (const char* key : {"baud = 9600\n", "parity = \"even\"\n", "stop_bits = 2\n"}) {
    CAPTURE(key);
    CHECK(said_of_link(kRtuKeys + key).empty());
    CHECK(said_of_link("transport = \"rtu_tcp\"\n" + std::string(key)).find("goes with transport") !=
          std::string::npos);
  }
}

TEST_CASE("a number of a manual is one of the 9999 from the first of its table") {
  const auto address = [](const char* table, const char* number) {
    return doubt_of_link("", "table = \"" + std::string(table) + "\", address = " + number);
  };
  CHECK(address("holding", "40000").empty());
  CHECK(address("holding", "40001").find("address = 0?") != std::string::npos);
  CHECK(address("holding", "49999").find("address = 9998?") != std::string::npos);
  CHECK(address("holding", "50000").empty());
  CHECK(address("input", "30000").empty());
  CHECK(address("input", "30001").find("address = 0?") != std::string::npos);
  CHECK(address("input", "39999").find("address = 9998?") != std::string::npos);
  CHECK(address("input", "40000").empty());
  CHECK(address("coil", "1").empty());  // numbers of coils are addresses, too
}

TEST_CASE("only a server that listens to other machines needs to allow them") {
  for (const char* host : {"localhost", "[::1]", "127.0.0.1", "127.1.2.3"})
    CHECK(doubt_of_link("address = \"" + std::string(host) + ":502\"\n").empty());
  for (const char* host : {"0.0.0.0", "192.168.1.5", "[::]", "12.7.0.1"}) {
    const std::string keys = "address = \"" + std::string(host) + ":502\"\n";
    CHECK(doubt_of_link(keys).find("only this machine may connect") != std::string::npos);
    CHECK(doubt_of_link("role = \"client\"\n" + keys).empty());
    CHECK(doubt_of_link(keys + "allow = [\"10.0.0.0/8\"]\n").empty());
  }
  CHECK(doubt_of_link(kRtuKeys).empty());
}

TEST_CASE("two servers have a port of their own or an address of their own") {
  const auto both = [](const std::string& a, const std::string& b) {
    const auto server = [](const std::string& address, const char* signal) {
      return "[[modbus]]\naddress = \"" + address + "\"\n[modbus.signals]\n" + signal +
             " = { address = 0 }\n";
    };
    return refusal(server(a, "feed_pressure_bar") + server(b, "rod_count"));
  };
  const std::string taken = "is a port that two servers listen at";
  CHECK(both("127.0.0.1:1502", "127.0.0.1:1503").empty());
  CHECK(both("127.0.0.1:1502", "127.0.0.2:1502").empty());
  CHECK(both("0.0.0.0:1502", "127.0.0.1:1503").empty());
  CHECK(both("127.0.0.1:1502", "127.0.0.1:1502").find(taken) != std::string::npos);
  for (const char* any : {"0.0.0.0:1502", "[::]:1502"}) {
    CHECK(both(any, "127.0.0.1:1502").find(taken) != std::string::npos);
    CHECK(both("127.0.0.1:1502", any).find(taken) != std::string::npos);
  }
}

TEST_CASE("clients that share a line agree on everything that the line has once") {
  const auto both = [](const std::string& a, const std::string& b) {
    const auto client = [](const std::string& keys, const char* signal) {
      return "[[modbus]]\nrole = \"client\"\n" + keys + "[modbus.signals]\n" + signal +
             " = { address = 0 }\n";
    };
    return refusal(client(kRtuKeys + a, "feed_pressure_bar") + client(kRtuKeys + b, "rod_count"));
  };
  CHECK(both("", "unit = 2\n").empty());
  for (const char* key :
       {"baud = 9600\n", "parity = \"odd\"\n", "stop_bits = 2\n", "timeout_ms = 321\n", "pause_ms = 321\n"}) {
    CAPTURE(key);
    CHECK(both(key, std::string(key) + "unit = 2\n").empty());
    CHECK(both("", std::string(key) + "unit = 2\n").find("is a line that another [[modbus]] shares") !=
          std::string::npos);
  }
}
