#include "can/kernel_filter.hpp"

#include <algorithm>

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
