#include "rigsound/socket/tcp_listener.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "rigsound/device_error.hpp"
#include "socket/resolve.hpp"

namespace rigsound {

namespace {

/// A socket of `type` that is bound.
FileDescriptor bound(const HostPort& where, int type, const StopEvent& stop) {
  const auto fail = [&](const std::string& why) {
    return DeviceError(text_of(where) + ": cannot listen: " + why);
  };
  std::string problem;
  const Addresses found = resolve(where, type, AI_PASSIVE, stop, problem);
  if (found == nullptr) throw fail(problem);
  FileDescriptor fd(::socket(found->ai_family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;
  if (fd && type == SOCK_STREAM) ::setsockopt(fd.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool good = fd && ::bind(fd.get(), found->ai_addr, found->ai_addrlen) == 0 &&
                    (type != SOCK_STREAM || ::listen(fd.get(), SOMAXCONN) == 0);
  if (!good) throw fail(std::strerror(errno));
  return fd;
}

}  // namespace

FileDescriptor listen_tcp(const HostPort& where, const StopEvent& stop) {
  return bound(where, SOCK_STREAM, stop);
}
FileDescriptor listen_udp(const HostPort& where, const StopEvent& stop) {
  return bound(where, SOCK_DGRAM, stop);
}

int bound_port(const FileDescriptor& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (!socket || ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  // The port lies alike in sockaddr_in6.
  return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace rigsound
