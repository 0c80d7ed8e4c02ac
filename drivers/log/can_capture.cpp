#include "log/can_capture.hpp"

#include <linux/can.h>
#include <linux/if_ether.h>
#include <pcap/dlt.h>

#include <algorithm>

namespace rigsound::log {
namespace {

constexpr std::size_t kHead = 8;                            // identifier, length, flags, two reserved
constexpr std::uint8_t kFdBrs = 1, kFdEsi = 2, kFdFdf = 4;  // of the flags, draft-ietf-opsawg-pcaplinktype

std::uint32_t big_endian_16(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at] << 8 | bytes[at + 1]);
}
std::uint32_t big_endian_32(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return big_endian_16(bytes, at) << 16 | big_endian_16(bytes, at + 2);
}

/// Where the frame begins and what protocol it is; 0: no CAN.
struct Payload {
  std::size_t at = 0;
  std::uint32_t protocol = 0;
};

Payload payload_of(const CapturedPacket& packet) {
  const std::vector<std::uint8_t>& bytes = packet.bytes;
  switch (packet.link_type) {
    case DLT_CAN_SOCKETCAN:
      return {0, ETH_P_CAN};
    case DLT_LINUX_SLL:
      return bytes.size() >= 16 ? Payload{16, big_endian_16(bytes, 14)} : Payload{};
    case DLT_LINUX_SLL2:
      return bytes.size() >= 20 ? Payload{20, big_endian_16(bytes, 0)} : Payload{};
    default:
      return {};
  }
}

std::string interface_of(const CapturedPacket& packet) {
  const bool named = !packet.interface.empty() && packet.interface != "any";
  if (named) return packet.interface;
  return packet.link_type == DLT_LINUX_SLL2 ? "if" + std::to_string(big_endian_32(packet.bytes, 4)) : "can0";
}

}  // namespace

std::optional<CanRecord> parse_can_packet(const CapturedPacket& packet) {
  const Payload payload = payload_of(packet);
  const std::vector<std::uint8_t>& bytes = packet.bytes;
  if (payload.protocol != ETH_P_CAN && payload.protocol != ETH_P_CANFD) return std::nullopt;
  if (bytes.size() < payload.at + kHead) return std::nullopt;
  const std::uint32_t id = big_endian_32(bytes, payload.at);
  const std::size_t size = bytes[payload.at + 4];
  const std::uint8_t flags = bytes[payload.at + 5];
  CanRecord record;
  can::Frame& f = record.frame;
  f.fd = payload.protocol == ETH_P_CANFD || (flags & kFdFdf) != 0 || size > CAN_MAX_DLEN;
  if (size > (f.fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN) || bytes.size() - payload.at - kHead < size)
    return std::nullopt;
  f.extended = (id & CAN_EFF_FLAG) != 0;
  f.remote = (id & CAN_RTR_FLAG) != 0;
  if (f.remote && f.fd) return std::nullopt;  // CAN FD has no remote requests
  f.error = (id & CAN_ERR_FLAG) != 0;
  f.id = id & (f.extended || f.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  f.bit_rate_switch = f.fd && (flags & kFdBrs) != 0;
  f.error_passive = f.fd && (flags & kFdEsi) != 0;
  f.size = static_cast<std::uint8_t>(size);
  const auto data = bytes.begin() + static_cast<std::ptrdiff_t>(payload.at + kHead);
  if (!f.remote) std::copy_n(data, size, f.data.begin());
  record.time_ns = packet.time_ns;
  record.interface = interface_of(packet);
  return record;
}

bool CanCapture::next(CanRecord& record) {
  CapturedPacket packet;
  while (file_.next(packet)) {
    const auto found = parse_can_packet(packet);
    if (!found) {
      ++counts_.other;
      continue;
    }
    ++counts_.frames;
    if (found->frame.error) ++counts_.error_frames;
    record = *found;
    return true;
  }
  return false;
}

}  // namespace rigsound::log
