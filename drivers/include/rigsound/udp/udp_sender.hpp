// Sends datagrams, as a simulator would.
#pragma once

#include <string>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::udp {

/// Errors: DeviceError when the address is none. Thread: OFF.
class UdpSender {
 public:
  /// `address`: HOST:PORT or [V6]:PORT.
  explicit UdpSender(const std::string& address);

  /// Never waits. False when nobody listens there, when it is too long, or when the network takes no more.
  bool send(const std::string& text) const;

 private:
  FileDescriptor socket_;
};

}  // namespace rigsound::udp
