// Only sockets are ever removed, and only dead ones or our own.
#include "rigsound/socket/unix_listener.hpp"

#include <doctest/doctest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <filesystem>
#include <memory>

#include "rigsound/device_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

struct SocketPath {
  explicit SocketPath(const std::string& name) : text((folder.path / name).string()) {}
  struct stat about() const {
    struct stat s {};
    REQUIRE(::lstat(text.c_str(), &s) == 0);
    return s;
  }
  TemporaryFolder folder;
  std::string text;
};

/// A socket of another program.
FileDescriptor bound(const std::string& path, int type) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, path.size());
  FileDescriptor fd(::socket(AF_UNIX, type, 0));
  REQUIRE(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  return fd;
}

}  // namespace

TEST_CASE("A dead socket is replaced, a living one is not; only user and group may use it") {
  const SocketPath path("s");
  { const FileDescriptor dead = bound(path.text, SOCK_STREAM); }
  const UnixListener alive(path.text);
  CHECK_THROWS_AS(UnixListener{path.text}, DeviceError);
  CHECK((path.about().st_mode & 0777) == 0660);
  CHECK(socket_path_problem(path.text).empty());
}

TEST_CASE("A socket that another program uses, of whatever kind, stays") {
  const SocketPath path("s");
  const FileDescriptor other = bound(path.text, SOCK_DGRAM);
  const ino_t before = path.about().st_ino;
  CHECK(complaint([&] { UnixListener{path.text}; }) ==
        path.text + ": cannot listen: another program listens there");
  CHECK(path.about().st_ino == before);
}

TEST_CASE("The name goes with the listener, unless it is another's by now") {
  const SocketPath path("s");
  { const UnixListener listener(path.text); }
  CHECK_FALSE(fs::exists(path.text));
  {
    const UnixListener listener(path.text);
    fs::rename(path.text, path.text + ".old");
    const UnixListener next(path.text);
    fs::rename(path.text, path.text + ".next");
    path.folder.write("s", "mine");
  }
  CHECK(content(path.text) == "mine");
  CHECK(fs::exists(path.text + ".old"));
}

TEST_CASE("Mode and group of the socket are those asked for") {
  const SocketPath path("s");
  const gid_t own = ::getegid();
  gid_t groups[64];
  const int count = ::getgroups(64, groups);
  const gid_t other = ::geteuid() == 0 ? own + 1 : count > 0 ? groups[count - 1] : own;
  const UnixListener listener(path.text, {other, 0606});
  CHECK((path.about().st_mode & 0777) == 0606);
  CHECK(path.about().st_gid == other);
}

TEST_CASE("What is no socket stays, and is named") {
  const SocketPath path("x");
  const auto refused = [&](const std::string& what) {
    CHECK(socket_path_problem(path.text) == "is " + what + ", expected a socket, or nothing yet");
    CHECK(complaint([&] { UnixListener{path.text}; }) ==
          path.text + ": cannot listen: is " + what + ", expected a socket, or nothing yet");
    CHECK(fs::exists(fs::symlink_status(path.text)));
  };
  path.folder.write("x", "mine");
  refused("a file");
  CHECK(content(path.text) == "mine");
  fs::remove(path.text);
  fs::create_directory(path.text);
  refused("a folder");
  fs::remove(path.text);
  fs::create_symlink("nowhere", path.text);
  refused("a link");
  fs::remove(path.text);
  REQUIRE(::mkfifo(path.text.c_str(), 0600) == 0);
  refused("a pipe");
  CHECK(socket_path_problem("/dev/null") == "is a device, expected a socket, or nothing yet");
}

TEST_CASE("A path that leads through a file or is too long is no path for a socket") {
  const SocketPath path("a");
  CHECK(socket_path_problem(path.text + "/b/c").empty());  // folders are made
  path.folder.write("a", "mine");
  CHECK(socket_path_problem(path.text + "/b/c") ==
        "lies in " + path.text + ", which is a file, expected a folder");
  CHECK(socket_path_problem(std::string(200, 'x')) == "is 200 bytes long, expected at most 107");
  CHECK_THROWS_AS(UnixListener{std::string(200, 'x')}, DeviceError);
}
