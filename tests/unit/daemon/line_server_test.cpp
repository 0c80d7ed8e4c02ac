#include "line_server.hpp"

#include <doctest/doctest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>

#include "control_socket.hpp"
#include "rigsound/device_error.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

struct Served {
  Served() : server(listen_unix(path), {"\n", false, [](const std::string& r) { return "<" + r + ">\n"; }}) {}
  ~Served() { ::unlink(path.c_str()); }

  FileDescriptor client() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, path.size());
    FileDescriptor fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
    REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
  }

  std::string path =
      (std::filesystem::temp_directory_path() / ("rigsound_" + std::to_string(::getpid()) + ".sock"))
          .string();
  LineServer server;
};

void say(const FileDescriptor& fd, const std::string& text) {
  REQUIRE(::send(fd.get(), text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size()));
}

/// What has arrived, "closed" at the end of the stream.
std::string heard(const FileDescriptor& fd) {
  char bytes[4096];
  const ssize_t got = ::recv(fd.get(), bytes, sizeof bytes, 0);
  return got == 0 ? "closed" : std::string(bytes, got > 0 ? static_cast<std::size_t>(got) : 0);
}

}  // namespace

TEST_CASE("Requests in pieces and several at once are answered in turn, to the client that asked") {
  Served s;
  const FileDescriptor a = s.client(), b = s.client();
  say(a, "on");
  say(b, "x\ny\n");
  s.server.serve();
  CHECK(heard(a).empty());
  CHECK(heard(b) == "<x>\n<y>\n");
  say(a, "e\n");
  s.server.serve();
  CHECK(heard(a) == "<one>\n");
}

TEST_CASE("A client without an end is closed, the others stay") {
  Served s;
  const FileDescriptor endless = s.client(), other = s.client();
  for (int i = 0; i < 30; ++i) {
    ::send(endless.get(), std::string(4096, 'a').data(), 4096, MSG_NOSIGNAL);
    s.server.serve();
  }
  CHECK(heard(endless) == "closed");
  say(other, "x\n");
  s.server.serve();
  CHECK(heard(other) == "<x>\n");
}

TEST_CASE("A dead socket is replaced, a living one is not; only user and group may use it") {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("rigsound_dead_" + std::to_string(::getpid()))).string();
  { const FileDescriptor dead = listen_unix(path); }
  const FileDescriptor alive = listen_unix(path);
  CHECK_THROWS_AS(listen_unix(path), DeviceError);
  const auto mode = std::filesystem::status(path).permissions();
  CHECK((mode & std::filesystem::perms::others_all) == std::filesystem::perms::none);
  ::unlink(path.c_str());
  CHECK_THROWS_AS(listen_unix(std::string(200, 'x')), DeviceError);
}
