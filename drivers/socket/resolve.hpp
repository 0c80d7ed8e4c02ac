// Names of machines into addresses.
#pragma once

#include <netdb.h>

#include <memory>
#include <string>

#include "rigsound/bus/stop_event.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound {

using Addresses = std::unique_ptr<addrinfo, void (*)(addrinfo*)>;

/// Addresses for a socket of `type`, `flags` as for getaddrinfo(); none: `problem` says why. What must be
/// asked of a name server is waited for until `stop` is set. Thread: CT.
Addresses resolve(const HostPort& where, int type, int flags, const StopEvent& stop, std::string& problem);

}  // namespace rigsound
