// Where `rigsound ctl` finds the daemon.
#pragma once

#include <string>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::daemon {

/// A listening UNIX socket that only the user and the group may use; a dead one left at `path` is replaced.
/// Removed by unlink when the daemon ends. Errors: DeviceError, also when another daemon listens there.
FileDescriptor listen_unix(const std::string& path);

}  // namespace rigsound::daemon
