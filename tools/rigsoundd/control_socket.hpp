// Where `rigsound ctl` finds the daemon.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "rigsound/config/rig.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::daemon {

/// Who may use the socket beside its owner.
struct SocketAccess {
  std::optional<gid_t> group;  ///< nothing: the process's own
  mode_t mode = 0660;
};

/// As `[control] group` and `mode` say. Errors: InputError when this machine has no such group.
SocketAccess access_of(const config::Rig& rig);

/// A listening UNIX socket; a dead one left at `path` is replaced. Errors: DeviceError, also when another
/// daemon listens there, when something else than a socket lies there, or when the group cannot be given.
FileDescriptor listen_unix(const std::string& path, const SocketAccess& access = {});

/// Removes a socket, and nothing else, from `path`.
void remove_socket(const std::string& path);

}  // namespace rigsound::daemon
