#include "control_socket.hpp"

#include <grp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::daemon {
namespace {

[[noreturn]] void fail(const std::string& where, const std::string& why) {
  throw DeviceError(where + ": cannot listen: " + why);
}

sockaddr_un unix_address(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) fail(path, "the path is too long for a socket");
  path.copy(address.sun_path, path.size());
  return address;
}

bool somebody_listens(const sockaddr_un& address) {
  const FileDescriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  return ::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool is_socket(const std::string& path) {
  std::error_code error;
  return std::filesystem::symlink_status(path, error).type() == std::filesystem::file_type::socket;
}

/// Nobody but the owner gets in before this is done.
void let_in(const std::string& path, const SocketAccess& access) {
  const bool given = !access.group || ::lchown(path.c_str(), static_cast<uid_t>(-1), *access.group) == 0;
  if (given && ::chmod(path.c_str(), access.mode) == 0) return;
  const int error = errno;
  ::unlink(path.c_str());
  fail(path, given ? std::strerror(error)
                   : std::string("this user cannot give it to the group: ") + std::strerror(error));
}

}  // namespace

SocketAccess access_of(const config::Rig& rig) {
  const config::ControlOptions& control = rig.control;
  SocketAccess access{std::nullopt, control.mode_bits};
  if (control.group.empty()) return access;
  const group* const found = ::getgrnam(control.group.c_str());
  if (found == nullptr)
    throw InputError(
        rig.file.string(), control.group_line, "control.group",
        "there is no group \"" + control.group + "\", expected one of this machine (getent group)");
  access.group = found->gr_gid;
  return access;
}

void remove_socket(const std::string& path) {
  if (is_socket(path)) ::unlink(path.c_str());
}

FileDescriptor listen_unix(const std::string& path, const SocketAccess& access) {
  const sockaddr_un address = unix_address(path);
  if (somebody_listens(address)) fail(path, "another rigsoundd listens there");
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  remove_socket(path);
  if (std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
    fail(path, "something that is no socket lies there");
  FileDescriptor fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const mode_t mask = ::umask(0177);
  const bool bound = ::bind(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int error = errno;
  ::umask(mask);
  if (!bound) fail(path, std::strerror(error));
  let_in(path, access);
  if (::listen(fd.get(), SOMAXCONN) != 0) fail(path, std::strerror(errno));
  return fd;
}

}  // namespace rigsound::daemon
