#include "rigsound/udp/udp_sender.hpp"

#include <netdb.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "rigsound/device_error.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::udp {

UdpSender::UdpSender(const std::string& address) {
  const auto fail = [&](const char* why) { return DeviceError("udp " + address + ": " + why); };
  const auto where = parse_host_port(address);
  if (!where) throw fail("is no address, expected HOST:PORT or [V6]:PORT");
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICSERV;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(where->host.c_str(), std::to_string(where->port).c_str(), &hints, &found);
  if (error != 0) throw fail(::gai_strerror(error));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, ::freeaddrinfo);
  socket_.reset(::socket(found->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!socket_ || ::connect(socket_.get(), found->ai_addr, found->ai_addrlen) != 0)
    throw fail(std::strerror(errno));
}

bool UdpSender::send(const std::string& text) const {
  return ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(text.size());
}

}  // namespace rigsound::udp
