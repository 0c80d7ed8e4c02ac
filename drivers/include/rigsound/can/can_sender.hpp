// Puts frames on a CAN interface.
#pragma once

#include <cstdint>
#include <string>

#include "rigsound/can/frame.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::can {

/// Throws DeviceError when the interface is missing or down, or when it goes away while sending.
/// Thread: OFF, CT.
class CanSender {
 public:
  explicit CanSender(const std::string& interface);

  /// Waits while the interface's queue is full. A frame the interface cannot carry (FD on a classic
  /// bus) is refused: returns false.
  bool send(const Frame& frame);

  std::uint64_t waits() const { return waits_; }  ///< times the queue was full

 private:
  std::string interface_;
  FileDescriptor fd_;
  std::uint64_t waits_ = 0;
};

}  // namespace rigsound::can
