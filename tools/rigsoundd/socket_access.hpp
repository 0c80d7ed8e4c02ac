// Who may use the control socket.
#pragma once

#include "rigsound/config/rig.hpp"
#include "rigsound/socket/unix_listener.hpp"

namespace rigsound::daemon {

/// As `[control] group` and `mode` say. Errors: InputError when this machine has no such group.
SocketAccess access_of(const config::Rig& rig);

}  // namespace rigsound::daemon
