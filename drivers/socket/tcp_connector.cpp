#include "rigsound/socket/tcp_connector.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "rigsound/device_error.hpp"

namespace rigsound {
namespace {

/// 0, or why not.
int connect_within(int fd, const addrinfo& to, double timeout_s) {
  if (::connect(fd, to.ai_addr, to.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd poll{fd, POLLOUT, 0};
  if (::poll(&poll, 1, static_cast<int>(timeout_s * 1e3)) != 1) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

FileDescriptor connect_tcp(const HostPort& where, double timeout_s) {
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICSERV;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = ::getaddrinfo(where.host.c_str(), std::to_string(where.port).c_str(), &hints, &found);
  if (unknown != 0) throw DeviceError(std::string("cannot be reached: ") + ::gai_strerror(unknown));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, ::freeaddrinfo);
  int why = 0;
  for (const addrinfo* to = found; to != nullptr; to = to->ai_next) {
    FileDescriptor fd(::socket(to->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    why = fd ? connect_within(fd.get(), *to, timeout_s) : errno;
    if (why != 0) continue;
    const int on = 1;
    ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    ::fcntl(fd.get(), F_SETFL, ::fcntl(fd.get(), F_GETFL) & ~O_NONBLOCK);
    return fd;
  }
  throw DeviceError(std::string("cannot be reached: ") + std::strerror(why));
}

}  // namespace rigsound
