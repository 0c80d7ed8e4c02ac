#include "rigsound/socket/unix_listener.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "rigsound/device_error.hpp"
#include "rigsound/file/file_kind.hpp"

namespace rigsound {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongest = sizeof(sockaddr_un::sun_path) - 1;

[[noreturn]] void refuse_socket(const std::string& where, const std::string& why) {
  throw DeviceError(where + ": cannot listen: " + why);
}

sockaddr_un unix_address(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, kLongest);
  return address;
}

/// A socket of whatever kind that refuses nobody is not ours to remove.
bool is_dead(const sockaddr_un& address) {
  const FileDescriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  return ::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
         errno == ECONNREFUSED;
}

/// The nearest folder that is there, or what lies in its place.
fs::path nearest_there(fs::path folder) {
  std::error_code error;
  while (folder.has_relative_path() && !fs::exists(folder, error)) folder = folder.parent_path();
  return folder;
}

/// Nobody but the owner gets in before this is done.
void let_in(const std::string& path, const SocketAccess& access) {
  const bool given = !access.group || ::lchown(path.c_str(), static_cast<uid_t>(-1), *access.group) == 0;
  if (given && ::chmod(path.c_str(), access.mode) == 0) return;
  const int error = errno;
  ::unlink(path.c_str());
  refuse_socket(path, given ? std::strerror(error)
                            : std::string("this user cannot give it to the group: ") + std::strerror(error));
}

}  // namespace

std::string socket_path_problem(const std::string& path) {
  if (path.size() > kLongest)
    return "is " + std::to_string(path.size()) + " bytes long, expected at most " + std::to_string(kLongest);
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (!kind_word(type).empty() && type != fs::file_type::socket)
    return "is " + std::string(kind_word(type)) + ", expected a socket, or nothing yet";
  const fs::path folder = nearest_there(fs::absolute(path, error).parent_path());
  if (!fs::is_directory(folder, error))
    return "lies in " + folder.string() + ", which is " +
           std::string(kind_word(fs::status(folder, error).type())) + ", expected a folder";
  return {};
}

UnixListener::UnixListener(std::string path, const SocketAccess& access) : path_(std::move(path)) {
  if (const std::string problem = socket_path_problem(path_); !problem.empty()) refuse_socket(path_, problem);
  const sockaddr_un address = unix_address(path_);
  std::error_code error;
  if (fs::exists(fs::symlink_status(path_, error))) {
    if (!is_dead(address)) refuse_socket(path_, "another program listens there");
    ::unlink(path_.c_str());
  }
  fs::create_directories(fs::path(path_).parent_path(), error);
  fd_.reset(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const mode_t mask = ::umask(0177);
  const bool bound = ::bind(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int why = errno;
  ::umask(mask);
  if (!bound) refuse_socket(path_, std::strerror(why));
  let_in(path_, access);
  if (::listen(fd_.get(), SOMAXCONN) != 0) refuse_socket(path_, std::strerror(errno));
  ::lstat(path_.c_str(), &ours_);
}

UnixListener::~UnixListener() {
  struct stat there {};
  const bool ours =
      ::lstat(path_.c_str(), &there) == 0 && there.st_dev == ours_.st_dev && there.st_ino == ours_.st_ino;
  if (ours) ::unlink(path_.c_str());
}

}  // namespace rigsound
