#include "rigsound/socket/tcp_listener.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "rigsound/device_error.hpp"

namespace rigsound {

namespace {

/// A socket of `type` that is bound.
FileDescriptor bound(const HostPort& where, int type) {
  const auto fail = [&](const char* why) { return DeviceError(text_of(where) + ": cannot listen: " + why); };
  addrinfo hints{};
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  hints.ai_socktype = type;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(where.host.c_str(), std::to_string(where.port).c_str(), &hints, &found);
  if (error != 0) throw fail(::gai_strerror(error));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, ::freeaddrinfo);
  FileDescriptor fd(::socket(found->ai_family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;
  if (fd && type == SOCK_STREAM) ::setsockopt(fd.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool good = fd && ::bind(fd.get(), found->ai_addr, found->ai_addrlen) == 0 &&
                    (type != SOCK_STREAM || ::listen(fd.get(), SOMAXCONN) == 0);
  if (!good) throw fail(std::strerror(errno));
  return fd;
}

}  // namespace

FileDescriptor listen_tcp(const HostPort& where) { return bound(where, SOCK_STREAM); }
FileDescriptor listen_udp(const HostPort& where) { return bound(where, SOCK_DGRAM); }

int bound_port(const FileDescriptor& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (!socket || ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  // The port lies alike in sockaddr_in6.
  return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace rigsound
