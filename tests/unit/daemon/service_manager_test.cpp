// What systemd is told, read from the socket it would listen on.
#include "service_manager.hpp"

#include <doctest/doctest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "rigsound/file/file_descriptor.hpp"

using namespace rigsound;

namespace {

/// Listens in the abstract name space, where no file is left behind.
class Listener {
 public:
  Listener() : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    const std::string name = "@rigsound-test-" + std::to_string(::getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    name.copy(address.sun_path + 1, name.size() - 1, 1);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    REQUIRE(::bind(fd_.get(), reinterpret_cast<const sockaddr*>(&address), size) == 0);
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
    ::setenv("WATCHDOG_USEC", "2000000", 1);
  }
  ~Listener() {
    ::unsetenv("NOTIFY_SOCKET");
    ::unsetenv("WATCHDOG_USEC");
  }
  /// The next message, or nothing.
  std::string heard() const {
    std::array<char, 256> bytes{};
    const ssize_t got = ::recv(fd_.get(), bytes.data(), bytes.size(), 0);
    return got > 0 ? std::string(bytes.data(), static_cast<std::size_t>(got)) : "";
  }

 private:
  FileDescriptor fd_;
};

}  // namespace

TEST_CASE("The watchdog is fed twice in its time, and only while blocks are rendered") {
  const Listener systemd;
  daemon::ServiceManager service;
  service.watch(1, 0.0);
  CHECK(systemd.heard() == "WATCHDOG=1");
  service.watch(2, 0.9);
  CHECK(systemd.heard().empty());
  service.watch(3, 1.0);
  CHECK(systemd.heard() == "WATCHDOG=1");
  for (double now_s = 1; now_s < 10; now_s += 0.1) service.watch(3, now_s);
  CHECK(systemd.heard().empty());
  service.watch(4, 10);
  CHECK(systemd.heard() == "WATCHDOG=1");
}

TEST_CASE("A status is told when it changes") {
  const Listener systemd;
  daemon::ServiceManager service;
  service.ready();
  CHECK(systemd.heard() == "READY=1");
  service.status("can can0 up");
  service.status("can can0 up");
  CHECK(systemd.heard() == "STATUS=can can0 up");
  CHECK(systemd.heard().empty());
  service.stopping();
  CHECK(systemd.heard() == "STOPPING=1");
}
