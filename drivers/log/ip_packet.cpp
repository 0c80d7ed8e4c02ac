#include "log/ip_packet.hpp"

#include <pcap/dlt.h>

#include <algorithm>

namespace rigsound::log {
namespace {

constexpr unsigned kIpv4 = 0x0800, kIpv6 = 0x86dd, kVlan = 0x8100, kProviderVlan = 0x88a8;

/// A view that never reads past its end.
struct View {
  const std::uint8_t* bytes;
  std::size_t size;

  bool has(std::size_t n) const { return size >= n; }
  unsigned word(std::size_t at) const { return static_cast<unsigned>(bytes[at] << 8 | bytes[at + 1]); }
  View from(std::size_t at) const { return {bytes + at, size - at}; }
};

/// The IP packet inside, or an empty view.
View strip_link(int link_type, View v) {
  const View none{nullptr, 0};
  std::size_t head = 0;
  switch (link_type) {
    case DLT_RAW:
      return v;
    case DLT_NULL:
    case DLT_LOOP:
      return v.has(4) ? v.from(4) : none;
    case DLT_LINUX_SLL:
      return v.has(16) ? v.from(16) : none;
    case DLT_LINUX_SLL2:
      return v.has(20) ? v.from(20) : none;
    case DLT_EN10MB:
      break;
    default:
      return none;
  }
  for (head = 14; v.has(head); head += 4) {
    const unsigned type = v.word(head - 2);
    if (type == kIpv4 || type == kIpv6) return v.from(head);
    if (type != kVlan && type != kProviderVlan) return none;
  }
  return none;
}

/// What an IP packet carries, and between whom; ports are not known yet.
struct IpPayload {
  int protocol = 0;
  Endpoint from, to;
  View inside{nullptr, 0};
};

bool strip_ipv4(View v, IpPayload& p) {
  if (!v.has(20)) return false;
  const std::size_t head = (v.bytes[0] & 15) * 4, total = v.word(2);
  const bool fragment = (v.word(6) & 0x3fff) != 0;
  if (head < 20 || fragment || total < head || !v.has(total)) return false;
  p.protocol = v.bytes[9];
  std::copy_n(v.bytes + 12, 4, p.from.address.begin());
  std::copy_n(v.bytes + 16, 4, p.to.address.begin());
  p.inside = {v.bytes + head, total - head};  // Ethernet pads short packets
  return true;
}

bool strip_ipv6(View v, IpPayload& p) {
  if (!v.has(40)) return false;
  const std::size_t size = v.word(4);
  if (!v.has(40 + size)) return false;
  p.protocol = v.bytes[6];
  std::copy_n(v.bytes + 8, 16, p.from.address.begin());
  std::copy_n(v.bytes + 24, 16, p.to.address.begin());
  p.from.v6 = p.to.v6 = true;
  p.inside = {v.bytes + 40, size};
  return true;
}

/// The payload of `protocol`, ports told, or nothing.
std::optional<IpPayload> payload_of(int link_type, View packet, int protocol, std::size_t least) {
  const View ip = strip_link(link_type, packet);
  IpPayload payload;
  if (!ip.has(1)) return std::nullopt;
  const int version = ip.bytes[0] >> 4;
  const bool good = version == 4 ? strip_ipv4(ip, payload) : version == 6 && strip_ipv6(ip, payload);
  if (!good || payload.protocol != protocol || !payload.inside.has(least)) return std::nullopt;
  payload.from.port = static_cast<std::uint16_t>(payload.inside.word(0));
  payload.to.port = static_cast<std::uint16_t>(payload.inside.word(2));
  return payload;
}

}  // namespace

std::optional<TcpPacket> parse_packet(int link_type, const std::uint8_t* bytes, std::size_t size) {
  const auto payload = payload_of(link_type, {bytes, size}, kTcp, 20);
  if (!payload) return std::nullopt;
  const View v = payload->inside;
  const std::size_t head = (v.bytes[12] >> 4) * 4;
  if (head < 20 || !v.has(head)) return std::nullopt;
  TcpPacket p;
  p.from = payload->from;
  p.to = payload->to;
  p.sequence = v.word(4) << 16 | v.word(6);
  p.syn = (v.bytes[13] & 2) != 0;
  p.ack = (v.bytes[13] & 16) != 0;
  p.data = v.bytes + head;
  p.size = v.size - head;
  return p;
}

std::optional<UdpPacket> parse_udp_packet(int link_type, const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t kHead = 8;
  const auto payload = payload_of(link_type, {bytes, size}, kUdp, kHead);
  if (!payload) return std::nullopt;
  const std::size_t length = payload->inside.word(4);
  if (length < kHead || !payload->inside.has(length)) return std::nullopt;
  return UdpPacket{payload->from, payload->to, payload->inside.bytes + kHead, length - kHead};
}

}  // namespace rigsound::log
