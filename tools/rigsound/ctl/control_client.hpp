// The other end of the daemon's control socket.
#pragma once

#include <string>

#include "rigsound/config/json.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::tools {

class ControlClient {
 public:
  /// Errors: DeviceError when no daemon listens there.
  explicit ControlClient(const std::string& socket);

  /// Errors: DeviceError when the daemon goes away, std::runtime_error with its words when it refuses.
  Json ask(const Json& request);

  /// The next line that the daemon says unasked, to a client that has subscribed; waits for it. Errors:
  /// DeviceError when the daemon goes away.
  Json next_event();

 private:
  Json next_object();
  std::string next_line();

  std::string socket_;
  FileDescriptor fd_;
  std::string unread_;
};

}  // namespace rigsound::tools
