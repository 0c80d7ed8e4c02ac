// A CAN frame of a log.
#pragma once

#include <cstdint>
#include <string>

#include "rigsound/can/frame.hpp"

namespace rigsound::log {

/// A frame, when and where it was seen.
struct CanRecord {
  std::int64_t time_ns = 0;  ///< since the epoch, or whatever the recorder counted from
  std::string interface;
  can::Frame frame;
};

}  // namespace rigsound::log
