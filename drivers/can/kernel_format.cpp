#include "can/kernel_format.hpp"

#include <algorithm>
#include <cstring>

namespace rigsound::can {
namespace {

// J1939-21: priority (bits 26-28) is no part of a match; the PS byte is a destination when PF < 240.
can_filter j1939_filter(const MessageMatch& match) {
  constexpr canid_t kReservedPagePf = 0x03ff0000, kPs = 0x0000ff00, kSource = 0x000000ff;
  const bool ps_is_destination = ((match.id >> 16) & 0xff) < 240;
  can_filter filter{match.id, kReservedPagePf};
  if (!ps_is_destination) filter.can_mask |= kPs;
  if (match.source) {
    filter.can_mask |= kSource;
    filter.can_id = (match.id & ~kSource) | *match.source;
  }
  return filter;
}

can_filter filter_of(const MessageMatch& match) {
  can_filter filter =
      match.j1939 ? j1939_filter(match) : can_filter{match.id, match.extended ? CAN_EFF_MASK : CAN_SFF_MASK};
  if (match.j1939 || match.extended) filter.can_id |= CAN_EFF_FLAG;
  filter.can_mask |= CAN_EFF_FLAG | CAN_RTR_FLAG;
  filter.can_id &= filter.can_mask;
  return filter;
}

}  // namespace

Frame from_kernel(const canfd_frame& raw, std::size_t size) {
  Frame f;
  f.extended = (raw.can_id & CAN_EFF_FLAG) != 0;
  f.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
  f.error = (raw.can_id & CAN_ERR_FLAG) != 0;
  f.id = raw.can_id & (f.extended || f.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  f.fd = size == CANFD_MTU;
  f.size = std::min<std::uint8_t>(raw.len, f.fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN);
  if (f.fd) {
    f.bit_rate_switch = (raw.flags & CANFD_BRS) != 0;
    f.error_passive = (raw.flags & CANFD_ESI) != 0;
  } else {
    can_frame classic;
    std::memcpy(&classic, &raw, sizeof classic);
    f.raw_dlc = classic.len == CAN_MAX_DLEN && classic.len8_dlc > CAN_MAX_DLEN ? classic.len8_dlc : 0;
  }
  if (!f.remote) std::copy_n(raw.data, f.size, f.data.begin());
  return f;
}

std::size_t to_kernel(const Frame& f, canfd_frame& raw) {
  raw = {};
  raw.can_id =
      f.id | (f.extended ? CAN_EFF_FLAG : 0) | (f.remote ? CAN_RTR_FLAG : 0) | (f.error ? CAN_ERR_FLAG : 0);
  raw.len = f.size;
  std::copy_n(f.data.begin(), f.size, raw.data);
  if (f.fd) {
    raw.flags = static_cast<__u8>((f.bit_rate_switch ? CANFD_BRS : 0) | (f.error_passive ? CANFD_ESI : 0));
    return CANFD_MTU;
  }
  can_frame classic;
  std::memcpy(&classic, &raw, sizeof classic);
  classic.len8_dlc = f.raw_dlc;
  std::memcpy(&raw, &classic, sizeof classic);
  return CAN_MTU;
}

std::vector<can_filter> kernel_filters(const std::vector<MessageMatch>& wanted) {
  std::vector<can_filter> filters;
  for (const MessageMatch& match : wanted) {
    const can_filter filter = filter_of(match);
    const auto same = [&](const can_filter& f) {
      return f.can_id == filter.can_id && f.can_mask == filter.can_mask;
    };
    if (std::none_of(filters.begin(), filters.end(), same)) filters.push_back(filter);
  }
  return filters;
}

}  // namespace rigsound::can
