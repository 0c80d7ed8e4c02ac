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

  /// Errors: those of next_object(), std::runtime_error with the daemon's words when it refuses.
  Json ask(const Json& request);

  /// The next line that the daemon says: to a client that has subscribed, unasked. Waits for it. Errors:
  /// DeviceError when the daemon goes away, or what is there is none.
  Json next_object();

 private:
  std::string next_line();

  std::string socket_;
  FileDescriptor fd_;
  std::string unread_;
};

}  // namespace rigsound::tools
