#include "log/tcp_packet.hpp"

#include <pcap/dlt.h>

#include <algorithm>

namespace rigsound::log {
namespace {

constexpr int kTcp = 6;
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

bool strip_tcp(View v, TcpPacket& p) {
  if (!v.has(20)) return false;
  const std::size_t head = (v.bytes[12] >> 4) * 4;
  if (head < 20 || !v.has(head)) return false;
  p.from.port = static_cast<std::uint16_t>(v.word(0));
  p.to.port = static_cast<std::uint16_t>(v.word(2));
  p.sequence = v.word(4) << 16 | v.word(6);
  p.syn = (v.bytes[13] & 2) != 0;
  p.ack = (v.bytes[13] & 16) != 0;
  p.data = v.bytes + head;
  p.size = v.size - head;
  return true;
}

bool strip_ipv4(View v, TcpPacket& p) {
  if (!v.has(20)) return false;
  const std::size_t head = (v.bytes[0] & 15) * 4, total = v.word(2);
  const bool fragment = (v.word(6) & 0x3fff) != 0;
  if (head < 20 || v.bytes[9] != kTcp || fragment || total < head || !v.has(total)) return false;
  std::copy_n(v.bytes + 12, 4, p.from.address.begin());
  std::copy_n(v.bytes + 16, 4, p.to.address.begin());
  return strip_tcp({v.bytes + head, total - head}, p);  // Ethernet pads short packets
}

bool strip_ipv6(View v, TcpPacket& p) {
  if (!v.has(40) || v.bytes[6] != kTcp) return false;
  const std::size_t size = v.word(4);
  if (!v.has(40 + size)) return false;
  std::copy_n(v.bytes + 8, 16, p.from.address.begin());
  std::copy_n(v.bytes + 24, 16, p.to.address.begin());
  p.from.v6 = p.to.v6 = true;
  return strip_tcp({v.bytes + 40, size}, p);
}

}  // namespace

std::optional<TcpPacket> parse_packet(int link_type, const std::uint8_t* bytes, std::size_t size) {
  const View ip = strip_link(link_type, {bytes, size});
  TcpPacket packet;
  if (!ip.has(1)) return std::nullopt;
  const int version = ip.bytes[0] >> 4;
  const bool good = version == 4 ? strip_ipv4(ip, packet) : version == 6 && strip_ipv6(ip, packet);
  return good ? std::optional<TcpPacket>(packet) : std::nullopt;
}

}  // namespace rigsound::log
