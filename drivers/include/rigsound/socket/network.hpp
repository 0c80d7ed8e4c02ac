// Who calls us, and who may.
#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rigsound {

/// An IPv4 or IPv6 network that may connect, as written: "127.0.0.0/8", "::1/128", "192.168.1.5".
struct Network {
  std::string text;
  std::vector<std::uint8_t> address;  ///< 4 or 16 bytes, network byte order, host bits zero
  int prefix = 0;                     ///< bits that must match
};

/// The address in network byte order, 4 or 16 bytes; an IPv4 address in IPv6 clothes counts as IPv4.
std::vector<std::uint8_t> address_bytes(const sockaddr_storage& peer);

std::string address_text(const sockaddr_storage& peer);

/// Whether one of the networks holds the address; no networks at all means loopback only.
bool allowed(const std::vector<std::uint8_t>& address, const std::vector<Network>& networks);

}  // namespace rigsound
