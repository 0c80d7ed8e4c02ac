// Sockets that listen.
#pragma once

#include "rigsound/bus/stop_event.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

/// Non-blocking, bound, listening; port 0 takes a free one. A name server is waited for until `stop` is set.
/// Errors: DeviceError. Thread: CT.
FileDescriptor listen_tcp(const HostPort& where, const StopEvent& stop = {});

/// A datagram socket, else the same.
FileDescriptor listen_udp(const HostPort& where, const StopEvent& stop = {});

/// The port a listening socket is bound to; 0: none. Thread: any.
int bound_port(const FileDescriptor& socket);

}  // namespace rigsound
