// A daemon's end waits for nothing that may never come, and says so.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include "daemon/running_daemon.hpp"

using namespace rigsound;
using namespace rigsound::test;

TEST_CASE("A daemon that ends while a rig is read leaves its reading behind, and says so") {
  const SmallRig rig;
  const fs::path file = rig.folder.path / "rig.toml";
  daemon::Daemon daemon({file.string(), {}});
  Running running(daemon);
  fs::remove(file);
  REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
  const Line line(rig.socket());
  line.say({{"command", "reload"}});
  FileDescriptor rest_of_rig;  // there is somebody to write to once it is read; it does not end
  for (; !rest_of_rig; std::this_thread::yield())
    rest_of_rig = FileDescriptor(::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  CHECK_FALSE(running.end());
}

TEST_CASE("A daemon that ends with nothing under way leaves nothing behind") {
  const SmallRig rig;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  Running running(daemon);
  CHECK(running.end());
}
