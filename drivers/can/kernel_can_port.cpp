// SocketCAN: CAN_RAW sockets for the frames, a netlink socket for the comings and goings of interfaces.
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "bus/kernel_note.hpp"
#include "can/can_port.hpp"
#include "can/kernel_format.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::can {
namespace {

constexpr int kReceiveBuffer = 4 << 20;  // bytes: a second of a fully loaded FD bus

[[noreturn]] void fail_at(const std::string& interface, const std::string& what) {
  throw DeviceError("CAN interface " + interface + " " + what);
}

void set(int fd, int level, int name, const void* value, socklen_t size, const CanSocketOptions& options) {
  if (::setsockopt(fd, level, name, value, size) != 0)
    fail_at(options.interface, std::string("refuses a socket option: ") + std::strerror(errno));
}

void set_on(int fd, int level, int name, const CanSocketOptions& options) {
  const int on = 1;
  set(fd, level, name, &on, sizeof on, options);
}

// An interface that is down can be bound all the same; saying so here tells the user the fix.
int index_of_running(int fd, const std::string& interface) {
  ifreq request{};
  if (interface.size() >= IFNAMSIZ) fail_at(interface, "does not exist");
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(fd, SIOCGIFINDEX, &request) != 0) fail_at(interface, "does not exist");
  const int index = request.ifr_ifindex;
  if (::ioctl(fd, SIOCGIFFLAGS, &request) != 0) fail_at(interface, "does not exist");
  if ((request.ifr_flags & IFF_UP) == 0) fail_at(interface, "is down: `ip link set " + interface + " up`");
  return index;
}

void set_filters(int fd, const CanSocketOptions& options) {
  const can_err_mask_t errors = CAN_ERR_BUSOFF | CAN_ERR_RESTARTED | CAN_ERR_CRTL;
  set(fd, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors, options);
  if (options.everything) return;
  const std::vector<can_filter> filters = kernel_filters(options.wanted);
  set(fd, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
      static_cast<socklen_t>(filters.size() * sizeof(can_filter)), options);
}

class KernelCanSocket : public CanSocket {
 public:
  explicit KernelCanSocket(const CanSocketOptions& options)
      : fd_(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW)) {
    if (!fd_)
      fail_at(options.interface, std::string("cannot be used, no SocketCAN here: ") + std::strerror(errno));
    const int index = index_of_running(fd_.get(), options.interface);
    set_filters(fd_.get(), options);
    if (options.fd) set_on(fd_.get(), SOL_CAN_RAW, CAN_RAW_FD_FRAMES, options);
    set_on(fd_.get(), SOL_SOCKET, SO_TIMESTAMPNS, options);
    set_on(fd_.get(), SOL_SOCKET, SO_RXQ_OVFL, options);
    if (::setsockopt(fd_.get(), SOL_SOCKET, SO_RCVBUFFORCE, &kReceiveBuffer, sizeof kReceiveBuffer) != 0)
      set(fd_.get(), SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer, options);
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = index;
    if (::bind(fd_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
      fail_at(options.interface, std::string("cannot be bound: ") + std::strerror(errno));
    for (std::size_t i = 0; i < kMessages; ++i) {
      parts_[i] = {&raw_[i], sizeof raw_[i]};
      messages_[i].msg_hdr.msg_iov = &parts_[i];
      messages_[i].msg_hdr.msg_iovlen = 1;
    }
  }

  int receive(Arrival* out, std::size_t capacity, int timeout_ms, const StopEvent& stop) override {
    if (!stop.wait(fd_.get(), POLLIN, timeout_ms)) return 0;
    const std::size_t count = std::min(capacity, kMessages);
    for (std::size_t i = 0; i < count; ++i) {
      messages_[i].msg_hdr.msg_control = control_[i].data();
      messages_[i].msg_hdr.msg_controllen = control_[i].size();
    }
    const int got =
        ::recvmmsg(fd_.get(), messages_.data(), static_cast<unsigned>(count), MSG_DONTWAIT, nullptr);
    if (got < 0) return errno == EAGAIN || errno == EINTR ? 0 : -errno;
    for (int i = 0; i < got; ++i) {
      out[i].frame = from_kernel(raw_[i], messages_[i].msg_len);
      const KernelNote note = kernel_note(messages_[i].msg_hdr);
      out[i].realtime_s = note.realtime_s;
      if (note.dropped) dropped_ += *note.dropped - static_cast<std::uint32_t>(dropped_);  // wraps at 32 bits
    }
    return got;
  }

  std::uint64_t dropped() const override { return dropped_; }

 private:
  static constexpr std::size_t kMessages = 64;

  FileDescriptor fd_;
  std::uint64_t dropped_ = 0;
  std::array<canfd_frame, kMessages> raw_{};
  std::array<iovec, kMessages> parts_{};
  std::array<std::array<unsigned char, 128>, kMessages> control_{};
  std::array<mmsghdr, kMessages> messages_{};
};

class KernelCanPort : public CanPort {
 public:
  KernelCanPort() : links_(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE)) {
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    address.nl_groups = RTMGRP_LINK;
    if (links_ && ::bind(links_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
      links_.reset();
  }

  std::unique_ptr<CanSocket> open(const CanSocketOptions& options) override {
    return std::make_unique<KernelCanSocket>(options);
  }

  // Without netlink (a sandbox may forbid it) the pauses alone find the interface. A poll of fd -1 just
  // waits.
  void wait_for_change(int timeout_ms, const StopEvent& stop) override {
    if (!stop.wait(links_.get(), POLLIN, timeout_ms)) return;
    std::array<char, 8192> discarded{};
    while (::recv(links_.get(), discarded.data(), discarded.size(), MSG_DONTWAIT) > 0) {
    }
  }

 private:
  FileDescriptor links_;
};

}  // namespace

std::unique_ptr<CanPort> kernel_can_port() { return std::make_unique<KernelCanPort>(); }

}  // namespace rigsound::can
