// The kernel's filter for exactly the messages a rig uses.
#pragma once

#include <linux/can.h>

#include <vector>

#include "rigsound/can/signal_layout.hpp"

namespace rigsound::can {

/// One filter a message, without doubles. A frame passes when (id & can_mask) == (can_id & can_mask), flags
/// for extended and remote frames included; remote frames never pass.
std::vector<can_filter> kernel_filters(const std::vector<MessageMatch>& wanted);

}  // namespace rigsound::can
