// Who calls: addresses as sockets tell them, and which networks hold them.
#include "rigsound/socket/network.hpp"

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>

#include <cstring>
#include <string>
#include <vector>

using namespace rigsound;

namespace {

sockaddr_storage caller(const char* text) {
  sockaddr_storage storage{};
  sockaddr_in v4{};
  sockaddr_in6 v6{};
  if (::inet_pton(AF_INET, text, &v4.sin_addr) == 1) {
    v4.sin_family = AF_INET;
    std::memcpy(&storage, &v4, sizeof v4);
  } else {
    REQUIRE(::inet_pton(AF_INET6, text, &v6.sin6_addr) == 1);
    v6.sin6_family = AF_INET6;
    std::memcpy(&storage, &v6, sizeof v6);
  }
  return storage;
}

Network network_of(const char* address, int prefix) {
  return {address, address_bytes(caller(address)), prefix};
}

bool may_call(const char* text, const std::vector<Network>& networks) {
  return allowed(address_bytes(caller(text)), networks);
}

}  // namespace

TEST_CASE("an address is told in its own length, IPv4 in IPv6 clothes as IPv4") {
  using Address = std::vector<std::uint8_t>;
  CHECK(address_bytes(caller("192.168.1.5")) == Address{192, 168, 1, 5});
  CHECK(address_bytes(caller("::ffff:192.168.1.5")) == Address{192, 168, 1, 5});
  Address loopback(16, 0);
  loopback.back() = 1;
  CHECK(address_bytes(caller("::1")) == loopback);
  CHECK(address_text(caller("10.0.0.7")) == "10.0.0.7");
  CHECK(address_text(caller("::ffff:10.0.0.7")) == "10.0.0.7");
  CHECK(address_text(caller("fe80::1:2")) == "fe80::1:2");
}

TEST_CASE("without networks only this machine may call") {
  for (const char* own : {"127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"}) CHECK(may_call(own, {}));
  for (const char* other :
       {"126.0.0.1", "128.0.0.1", "10.0.0.1", "::2", "::101", "1::1", "::ffff:10.0.0.1", "::"})
    CHECK_FALSE(may_call(other, {}));
}

TEST_CASE("a network holds the addresses whose first bits are its own, of its kind only") {
  const std::vector<Network> networks = {network_of("10.1.128.0", 17), network_of("192.168.1.5", 32),
                                         network_of("fd00::", 8)};
  for (const char* in :
       {"10.1.128.0", "10.1.255.255", "192.168.1.5", "fd00::1", "fdff::", "::ffff:10.1.200.3"})
    CHECK(may_call(in, networks));
  for (const char* out : {"10.1.127.255", "10.2.128.0", "192.168.1.4", "192.168.1.7", "fc00::1", "127.0.0.1",
                          "::1", "::10.1.128.0"})
    CHECK_FALSE(may_call(out, networks));
  CHECK(may_call("8.8.8.8", {network_of("0.0.0.0", 0)}));
  CHECK_FALSE(may_call("::8", {network_of("0.0.0.0", 0)}));
}
