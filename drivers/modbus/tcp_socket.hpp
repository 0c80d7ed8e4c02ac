// Who calls the server, and who may.
#pragma once

#include <sys/socket.h>

#include <string>
#include <vector>

#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

/// The address in network byte order, 4 or 16 bytes; an IPv4 address in IPv6 clothes counts as IPv4.
std::vector<std::uint8_t> address_bytes(const sockaddr_storage& peer);

std::string address_text(const sockaddr_storage& peer);

/// Whether one of the networks holds the address; no networks at all means loopback only.
bool allowed(const std::vector<std::uint8_t>& address, const std::vector<Network>& networks);

}  // namespace rigsound::modbus
