// Sockets that listen.
#pragma once

#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

/// Non-blocking, bound, listening; port 0 takes a free one. Errors: DeviceError. Thread: CT.
FileDescriptor listen_tcp(const HostPort& where);

/// A datagram socket. Non-blocking, bound; port 0 takes a free one. Errors: DeviceError. Thread: CT.
FileDescriptor listen_udp(const HostPort& where);

/// The port a listening socket is bound to; 0: none. Thread: any.
int bound_port(const FileDescriptor& socket);

}  // namespace rigsound
