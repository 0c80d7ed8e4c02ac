// A TCP socket that listens.
#pragma once

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

/// Non-blocking, bound, listening; port 0 takes a free one. Errors: DeviceError. Thread: CT.
FileDescriptor listen_tcp(const HostPort& where);

}  // namespace rigsound
