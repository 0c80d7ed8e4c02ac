// What a running daemon writes to its log, so that whoever reads it knows what happened.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "daemon/kept_log.hpp"
#include "daemon/running_daemon.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

/// The lines that begin with one of `begins`, so much of each.
std::vector<std::string> told_in_order(const KeptLog& log, const std::vector<std::string>& begins) {
  std::vector<std::string> told;
  for (const std::string& line : log.lines())
    for (const std::string& begin : begins)
      if (line.rfind(begin, 0) == 0) told.push_back(begin);
  return told;
}

}  // namespace

TEST_CASE("The log tells each thing once, when it happens") {
  const SmallRig rig;
  const std::string file = (rig.folder.path / "rig.toml").string();
  const KeptLog log;
  {
    daemon::Daemon daemon({file, {}, config::Buses::kLeftOut});
    const Running running(daemon);
    const auto tell = [&](const nlohmann::json& request) { return ask(rig.socket(), request)["ok"]; };
    CHECK(tell({{"command", "mute"}, {"on", true}}) == true);
    CHECK(tell({{"command", "mute"}, {"on", false}}) == true);
    CHECK(tell({{"command", "set"}, {"key", "engine_rpm"}, {"value", 1500}}) == true);
    CHECK(tell({{"command", "release"}, {"key", "engine_rpm"}}) == true);
    CHECK(tell({{"command", "reload"}}) == true);
    rig.folder.write("rig.toml", "[audio]\ndevize = 1\n");
    CHECK(tell({{"command", "reload"}}) == false);
    rig.write_rig("");
    rig.folder.write("rig.toml", content(file) + "[mix]\ndrill_db = -3\n");
    CHECK(tell({{"command", "reload"}}) == true);
    const std::uint64_t blocks = status(rig.socket())["audio"]["blocks"];
    status_when(rig.socket(),  // a few rounds of the main thread
                [&](const nlohmann::json& s) { return s["audio"]["blocks"] > blocks + 300; });
  }
  const std::vector<std::string> once = {
      "info: audio thread: ",
      "info: manual: no bus is opened, signals are set by `rigsound ctl set`",
      "info: muted",
      "info: unmuted",
      "info: engine_rpm: 1500 by hand",
      "info: engine_rpm: released",
  };
  CHECK(told_in_order(log, once) == once);
  CHECK(log.count("warning: no sound: the rig's device is \"null\"") == 1);
  CHECK(log.count("info: reloaded " + file) == 2);
  CHECK(log.count("error: reload refused, the old rig goes on: " + file + ":2: ") == 1);
  CHECK(log.count("warning: sound card: ") == 0);
  CHECK(log.lines().back().rfind("info: stopped after ", 0) == 0);
}

TEST_CASE("A daemon with buses does not say that it has none, and names what only a restart changes") {
  const SmallRig rig;
  const KeptLog log;
  {
    daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
    const Running running(daemon);
    rig.folder.write("rig.toml", content(rig.folder.path / "rig.toml") + "metrics = \"127.0.0.1:9\"\n");
    const nlohmann::json reload = ask(rig.socket(), {{"command", "reload"}});
    CHECK(reload["not_applied"] == nlohmann::json({"control.metrics: , wanted 127.0.0.1:9"}));
  }
  CHECK(log.count("info: manual") == 0);
  CHECK(log.count("warning: reload: needs a restart: control.metrics") == 1);
}

TEST_CASE("The log tells when the output is turned down, and when it no longer is") {
  const SmallRig rig;
  rig.write_rig("[mix]\ndb_spl_at_0dbfs = 160\n[safety]\nmax_laeq_db = 40\n");
  const KeptLog log;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}, config::Buses::kLeftOut});
  const Running running(daemon);
  const char* down = "warning: output turned down: its level at the ear would pass max_laeq_db, 40 dB(A)";
  const char* up = "info: output no longer turned down";
  ask(rig.socket(), {{"command", "set"}, {"key", "engine_rpm"}, {"value", 1500}});
  status_when(rig.socket(), [&](const nlohmann::json&) { return log.count(down) > 0; });
  CHECK(log.count(down) == 1);
  CHECK(log.count(up) == 0);
  rig.write_rig("[mix]\ndb_spl_at_0dbfs = 160\n");  // no limit any more
  CHECK(ask(rig.socket(), {{"command", "reload"}})["ok"] == true);
  status_when(rig.socket(), [&](const nlohmann::json&) { return log.count(up) > 0; });
  CHECK(log.count(up) == 1);
  CHECK(log.count(down) == 1);
}
