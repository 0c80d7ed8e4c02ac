// A socket in the file system.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound {

/// Who may use the socket beside its owner.
struct SocketAccess {
  std::optional<gid_t> group;  ///< nothing: the process's own
  mode_t mode = 0660;
};

/// Why no socket can be made at `path`: "is a file, expected ...", something that is no folder in its way, or
/// too long a path; empty: nothing stands against it. Looks only. Thread: any.
std::string socket_path_problem(const std::string& path);

/// A listening socket and its name in the file system, which goes with it: never another's, never anything
/// else. Thread: CT.
class UnixListener {
 public:
  /// Non-blocking. A dead socket left at `path` is replaced. Errors: DeviceError, also when anybody listens
  /// there, when something else than a socket lies there, or when the group cannot be given.
  explicit UnixListener(std::string path, const SocketAccess& access = {});
  ~UnixListener();
  UnixListener(const UnixListener&) = delete;
  UnixListener& operator=(const UnixListener&) = delete;

  FileDescriptor take() { return std::move(fd_); }  ///< the name stays with the listener

 private:
  std::string path_;
  FileDescriptor fd_;
  struct stat ours_ {};
};

}  // namespace rigsound
