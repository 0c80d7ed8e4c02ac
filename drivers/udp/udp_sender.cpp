#include "rigsound/udp/udp_sender.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "rigsound/device_error.hpp"
#include "rigsound/socket/host_port.hpp"
#include "socket/resolve.hpp"

namespace rigsound::udp {

UdpSender::UdpSender(const std::string& address) {
  const auto fail = [&](const std::string& why) { return DeviceError("udp " + address + ": " + why); };
  const auto where = parse_host_port(address);
  if (!where) throw fail("is no address, expected HOST:PORT or [V6]:PORT");
  std::string problem;
  const Addresses found = resolve(*where, SOCK_DGRAM, 0, {}, problem);
  if (found == nullptr) throw fail(problem);
  socket_.reset(::socket(found->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!socket_ || ::connect(socket_.get(), found->ai_addr, found->ai_addrlen) != 0)
    throw fail(std::strerror(errno));
}

bool UdpSender::send(const std::string& text) const {
  return ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(text.size());
}

}  // namespace rigsound::udp
