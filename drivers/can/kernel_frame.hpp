// Our frame and the kernel's.
#pragma once

#include <linux/can.h>

#include <cstddef>

#include "rigsound/can/frame.hpp"

namespace rigsound::can {

/// `size` is what the socket delivered: CAN_MTU or CANFD_MTU.
Frame from_kernel(const canfd_frame& raw, std::size_t size);

/// Returns the size to send.
std::size_t to_kernel(const Frame& frame, canfd_frame& raw);

}  // namespace rigsound::can
