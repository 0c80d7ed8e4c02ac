// A TCP connection to a server.
#pragma once

#include "rigsound/bus/stop_event.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

/// Connected and non-blocking, small packets sent at once. Waits at most `timeout_s`, beside the time that a
/// name server takes, and not once `stop` is set. Errors: DeviceError. Thread: CT.
FileDescriptor connect_tcp(const HostPort& where, double timeout_s, const StopEvent& stop);

}  // namespace rigsound
