#include "rigsound/socket/tcp_connector.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "rigsound/device_error.hpp"
#include "socket/resolve.hpp"

namespace rigsound {
namespace {

/// 0, or why not.
int connect_within(int fd, const addrinfo& to, double timeout_s, const StopEvent& stop) {
  if (::connect(fd, to.ai_addr, to.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!stop.wait(fd, POLLOUT, static_cast<int>(timeout_s * 1e3))) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

FileDescriptor connect_tcp(const HostPort& where, double timeout_s, const StopEvent& stop) {
  std::string problem;
  const Addresses found = resolve(where, SOCK_STREAM, 0, stop, problem);
  for (const addrinfo* to = found.get(); to != nullptr && !stop.is_set(); to = to->ai_next) {
    FileDescriptor fd(::socket(to->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const int why = fd ? connect_within(fd.get(), *to, timeout_s, stop) : errno;
    const int on = 1;
    if (why == 0) ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (why == 0) return fd;
    problem = std::strerror(why);
  }
  throw DeviceError("cannot be reached: " + problem);
}

}  // namespace rigsound
