// Our frames and filters, and the kernel's.
#pragma once

#include <linux/can.h>

#include <cstddef>
#include <vector>

#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_layout.hpp"

namespace rigsound::can {

/// `size` is what the socket delivered: CAN_MTU or CANFD_MTU.
Frame from_kernel(const canfd_frame& raw, std::size_t size);

/// Returns the size to send.
std::size_t to_kernel(const Frame& frame, canfd_frame& raw);

/// One filter a message, without doubles. A frame passes when (id & can_mask) == (can_id & can_mask), flags
/// for extended and remote frames included; remote frames never pass.
std::vector<can_filter> kernel_filters(const std::vector<MessageMatch>& wanted);

}  // namespace rigsound::can
