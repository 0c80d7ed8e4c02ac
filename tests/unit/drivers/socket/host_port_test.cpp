#include "rigsound/socket/host_port.hpp"

#include <doctest/doctest.h>

using namespace rigsound;

TEST_CASE("Host and port, there and back") {
  const auto is = [](const char* text, const char* host, int port) {
    const auto got = parse_host_port(text, 502);
    INFO(text);
    REQUIRE(got);
    CHECK(got->host == host);
    CHECK(got->port == port);
    CHECK(parse_host_port(text_of(*got), 1)->host == host);
    CHECK(parse_host_port(text_of(*got), 1)->port == port);
  };
  is("127.0.0.1:1502", "127.0.0.1", 1502);
  is("plc.local", "plc.local", 502);
  is("[::1]:99", "::1", 99);
  is("[::1]", "::1", 502);
  for (const char* text : {"", ":502", "a:", "a:0", "a:65536", "a:x", "[::1", "[::1]x", "[]:1"})
    CHECK_FALSE(parse_host_port(text, 502));
  for (const char* text : {"plc.local", "[::1]", ""}) CHECK_FALSE(parse_host_port(text));
  CHECK(parse_host_port("plc.local:9000")->port == 9000);
}
