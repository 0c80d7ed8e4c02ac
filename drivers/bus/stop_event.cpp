#include "rigsound/bus/stop_event.hpp"

#include <sys/eventfd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>

#include "rigsound/device_error.hpp"

namespace rigsound {

StopEvent::StopEvent() : fd_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!fd_) throw DeviceError(std::string("no event can be made: ") + std::strerror(errno));
}

void StopEvent::set() noexcept {
  set_.store(true, std::memory_order_release);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t wrote = ::write(fd_.get(), &one, sizeof one);
}

bool StopEvent::wait(int fd, short events, int timeout_ms) const noexcept {
  std::array<pollfd, 2> polls = {to_poll(), pollfd{fd, events, 0}};
  return ::poll(polls.data(), polls.size(), timeout_ms) > 0 && polls[0].revents == 0 && polls[1].revents != 0;
}

}  // namespace rigsound
