#include "can/kernel_frame.hpp"

#include <algorithm>
#include <cstring>

namespace rigsound::can {

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

}  // namespace rigsound::can
