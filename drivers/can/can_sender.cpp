#include "rigsound/can/can_sender.hpp"

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "can/kernel_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::can {
namespace {

[[noreturn]] void fail_to_send(const std::string& interface, const std::string& what, int error) {
  throw DeviceError("CAN interface " + interface + ": " + what + ": " + std::strerror(error));
}

}  // namespace

CanSender::CanSender(const std::string& interface)
    : interface_(interface), fd_(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW)) {
  if (!fd_) fail_to_send(interface, "no SocketCAN here", errno);
  const int on = 1;
  ::setsockopt(fd_.get(), SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on);
  ::setsockopt(fd_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, nullptr, 0);  // sends only
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
  if (address.can_ifindex == 0) fail_to_send(interface, "does not exist", errno);
  if (::bind(fd_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    fail_to_send(interface, "cannot be bound", errno);
}

bool CanSender::send(const Frame& frame) {
  canfd_frame raw;
  const std::size_t size = to_kernel(frame, raw);
  while (::send(fd_.get(), &raw, size, 0) < 0) {
    if (errno == EINVAL || errno == EMSGSIZE) return false;
    if (errno != ENOBUFS && errno != EINTR) fail_to_send(interface_, "cannot send", errno);
    ++waits_;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace rigsound::can
