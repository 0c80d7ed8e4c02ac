#include <doctest/doctest.h>

#include "daemon/running_daemon.hpp"

using namespace rigsound;
using namespace rigsound::test;

TEST_CASE("A start with sounds that the engine cannot play names the sound set") {
  const SmallRig rig;
  rig.trim_db(-60);  // with the bank's own -60 dB more than the engine plays
  const std::string said = complaint([&] {
    const daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  });
  CHECK(said.rfind((rig.folder.path / "set").string() + ": cannot be played: ", 0) == 0);
  CHECK(said.find("gain_db") != std::string::npos);
}

TEST_CASE("A session that is full when the sounds can no longer be played ends, the sound goes on") {
  const SmallRig rig;
  const fs::path session = rig.folder.path / "s.session";
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {session, 4}});  // full from its start
  rig.trim_db(-60);
  const Running running(daemon);
  const auto broken = [](const nlohmann::json& s) {
    return !s["session"]["problem"].empty() && s["session"]["problem"] != "";
  };
  const nlohmann::json at_end = status_when(rig.socket(), broken);
  const std::string problem = at_end["session"]["problem"];
  CHECK(problem.find((rig.folder.path / "set").string() + ": cannot be played: ") != std::string::npos);
  CHECK(problem.find("gain_db") != std::string::npos);
  CHECK(at_end["session"]["recording"] == false);
  const std::uint64_t blocks = at_end["audio"]["blocks"];
  const nlohmann::json later =
      status_when(rig.socket(), [&](const nlohmann::json& s) { return s["audio"]["blocks"] > blocks + 10; });
  CHECK(later["audio"]["blocks"] > blocks + 10);
  CHECK(fs::exists(session));
}
