// A TCP connection to a server.
#pragma once

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

/// Connected and blocking again, small packets sent at once; waits at most `timeout_s`. Errors: DeviceError.
/// Thread: CT.
FileDescriptor connect_tcp(const HostPort& where, double timeout_s);

}  // namespace rigsound
