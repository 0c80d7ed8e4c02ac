#include "rig/network.hpp"

#include <arpa/inet.h>
#include <doctest/doctest.h>

#include <array>

using namespace rigsound;

TEST_CASE("addresses are read as inet_pton reads them") {
  for (const char* text : {"127.0.0.1", "0.0.0.0", "255.255.255.255", "192.168.1.5"}) {
    std::array<std::uint8_t, 4> expected{};
    REQUIRE(inet_pton(AF_INET, text, expected.data()) == 1);
    const auto network = config::parse_network(text);
    REQUIRE(network);
    CHECK(network->address == std::vector<std::uint8_t>(expected.begin(), expected.end()));
    CHECK(network->prefix == 32);
  }
  for (const char* text : {"::", "::1", "fe80::", "2001:db8:0:1:2:3:4:5", "1::8",
                           "1:2:3:4:5:6:7::", "::2:3:4:5:6:7:8", "ffff::FFFF", "2001:DB8::ff00:42:8329"}) {
    std::array<std::uint8_t, 16> expected{};
    REQUIRE(inet_pton(AF_INET6, text, expected.data()) == 1);
    const auto network = config::parse_network(text);
    INFO(text);
    REQUIRE(network);
    CHECK(network->address == std::vector<std::uint8_t>(expected.begin(), expected.end()));
    CHECK(network->prefix == 128);
  }
}

TEST_CASE("a prefix may not cut through set bits") {
  CHECK(config::parse_network("10.0.0.0/8")->prefix == 8);
  CHECK(config::parse_network("0.0.0.0/0")->prefix == 0);
  CHECK(config::parse_network("192.168.1.128/25")->prefix == 25);
  CHECK(config::parse_network("fe80::/10")->prefix == 10);
  for (const char* text : {"10.0.0.1/8", "192.168.1.128/24", "fe80::1/64"})
    CHECK_FALSE(config::parse_network(text));
}

TEST_CASE("what is no network is refused") {
  for (const char* text : {"",
                           "/8",
                           "localhost",
                           "1.2.3",
                           "1.2.3.4.5",
                           "1.2.3.256",
                           "1.2.3.-4",
                           "1.2.3.4/33",
                           "1.2.3.4/",
                           "1.2.3.4/x",
                           "1..2.3",
                           "::1/129",
                           ":::",
                           "1:2:3:4:5:6:7",
                           "1:2:3:4:5:6:7:8:9",
                           "12345::",
                           "1:2:3:4:5:6:7::8:9",
                           "1::2::3",
                           "g::",
                           "g::1",
                           "1::g",
                           "1::2:",
                           ":1::2",
                           "1:2:3:4:5:6:7:8:",
                           ":1:2:3:4:5:6:7:8",
                           "1:2:3:4:5:6:7:10000",
                           "1:2:3:4:5:6:7:-8",
                           "1:2:3:4:5:6:7:8::",
                           "1:2:3:4:5:6:7::8",
                           "1.2.3.",
                           "1.2.3.4.",
                           "1.2.3.4/-1",
                           "1:"}) {
    INFO(text);
    CHECK_FALSE(config::parse_network(text));
  }
}
