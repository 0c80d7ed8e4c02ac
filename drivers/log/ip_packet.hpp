// A captured packet, as far as TCP or UDP.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rigsound::log {

constexpr int kTcp = 6, kUdp = 17;  ///< protocol numbers of IP

struct Endpoint {
  std::array<std::uint8_t, 16> address{};  ///< IPv4 in the first four bytes
  bool v6 = false;
  std::uint16_t port = 0;

  bool operator<(const Endpoint& o) const {
    return address != o.address ? address < o.address : port < o.port;
  }
  bool operator==(const Endpoint& o) const { return address == o.address && port == o.port; }
};

struct TcpPacket {
  Endpoint from, to;
  std::uint32_t sequence = 0;
  bool syn = false, ack = false;
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

struct UdpPacket {
  Endpoint from, to;
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

/// `link_type`: a DLT_ value of libpcap; Ethernet with or without VLAN, Linux cooked, raw IP, BSD loopback.
/// Nothing when it is no whole TCP packet over IPv4 or IPv6. `data` points into `bytes`.
std::optional<TcpPacket> parse_packet(int link_type, const std::uint8_t* bytes, std::size_t size);

/// The same for UDP.
std::optional<UdpPacket> parse_udp_packet(int link_type, const std::uint8_t* bytes, std::size_t size);

}  // namespace rigsound::log
