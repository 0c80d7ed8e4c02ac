// What a CAN bus asks of the kernel, so that every loss can be injected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/bus/stop_event.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_layout.hpp"

namespace rigsound::can {

struct CanSocketOptions {
  std::string interface;
  bool fd = false;
  bool everything = false;           ///< no filter: all data frames
  std::vector<MessageMatch> wanted;  ///< otherwise the kernel passes these and controller errors only
};

/// One open, bound socket.
class CanSocket {
 public:
  virtual ~CanSocket() = default;
  /// Waits for frames and fetches up to `capacity`. Returns how many, 0 when the time is up or `stop` is set,
  /// or a negative errno value.
  virtual int receive(Arrival* out, std::size_t capacity, int timeout_ms, const StopEvent& stop) = 0;
  virtual std::uint64_t dropped() const = 0;  ///< by the kernel, on this socket
};

class CanPort {
 public:
  virtual ~CanPort() = default;
  /// Throws DeviceError saying which interface it is and in what state.
  virtual std::unique_ptr<CanSocket> open(const CanSocketOptions& options) = 0;
  /// Returns when a network link changed or `stop` is set, at the latest after `timeout_ms`.
  virtual void wait_for_change(int timeout_ms, const StopEvent& stop) = 0;
};

std::unique_ptr<CanPort> kernel_can_port();

}  // namespace rigsound::can
