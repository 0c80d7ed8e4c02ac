#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "daemon/kept_log.hpp"
#include "daemon/running_daemon.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/session/session_changes.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

bool is_recording(const nlohmann::json& status) { return status["session"]["recording"] == true; }

/// The output gain of every change that a session holds.
std::vector<float> gains_of_session(const fs::path& file) {
  const InputFile recorded(file, "session");
  session::SessionChanges told(recorded);
  std::vector<float> gains;
  for (session::Change change; told.next(change);) gains.push_back(change.state.output_gain);
  REQUIRE(gains.size() > 1);
  return gains;
}

}  // namespace

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
  daemon::Daemon daemon(
      {(rig.folder.path / "rig.toml").string(), {rig.folder.path / "sessions", 4}});  // full from its start
  rig.trim_db(-60);
  const Running running(daemon);
  const auto ended = [](const nlohmann::json& s) {  // by the thread that writes
    return s["session"]["problem"] != "" && s["session"]["recording"] == false;
  };
  const nlohmann::json at_end = status_when(rig.socket(), ended);
  const std::string problem = at_end["session"]["problem"];
  CHECK(problem.find((rig.folder.path / "set").string() + ": cannot be played: ") != std::string::npos);
  CHECK(problem.find("gain_db") != std::string::npos);
  CHECK(at_end["session"]["recording"] == false);
  const std::uint64_t blocks = at_end["audio"]["blocks"];
  const nlohmann::json later =
      status_when(rig.socket(), [&](const nlohmann::json& s) { return s["audio"]["blocks"] > blocks + 10; });
  CHECK(later["audio"]["blocks"] > blocks + 10);
  CHECK(fs::exists(at_end["session"]["file"].get<std::string>()));
}

TEST_CASE("A reload that changes no sound goes on with the session, one that does begins the next") {
  const SmallRig rig;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {rig.folder.path / "sessions", 1 << 20}});
  const Running running(daemon);
  const auto reload = [&] {
    CHECK(ask(rig.socket(), {{"command", "reload"}})["ok"] == true);
    return status_when(rig.socket(),
                       [](const nlohmann::json& s) { return s["session"]["recording"] == true; });
  };
  const auto file = [](const nlohmann::json& status) { return status["session"]["file"].get<std::string>(); };
  const std::string first = file(
      status_when(rig.socket(), [](const nlohmann::json& s) { return s["session"]["recording"] == true; }));
  ask(rig.socket(), {{"command", "set"}, {"key", "engine_rpm"}, {"value", 900}});
  status_when(rig.socket(), [](const nlohmann::json& s) { return s["meters"]["diesel"]["rms_db"] > -140; });

  CHECK(file(reload()) == first);
  rig.write_rig("[safety]\nfade_ms = 500\n");
  const nlohmann::json other_safety = reload();
  CHECK(file(other_safety) == first);
  CHECK(other_safety["reloads"] == 2);
  rig.write_rig("[mix]\ndrill_db = -3\n");
  reload();
  const std::string second = file(status_when(rig.socket(), [&](const nlohmann::json& s) {
    return s["session"]["recording"] == true && s["session"]["file"] != first;
  }));
  CHECK(second > first);
  CHECK(fs::exists(first));
  CHECK(fs::exists(second));
}

TEST_CASE("A rig named as the folder of sessions is refused, and stays") {
  const SmallRig rig;
  const fs::path file = rig.folder.path / "rig.toml";
  const std::string before = content(file);
  CHECK(complaint([&] {
          const daemon::Daemon daemon({file.string(), {file, 1 << 20}});
        }).rfind(file.string() + ": is no folder", 0) == 0);
  CHECK(content(file) == before);
}

TEST_CASE("The sound is shut before an engine ends and opened after one has begun") {
  const SmallRig rig;
  const fs::path sessions = rig.folder.path / "sessions";
  fs::path first, second;
  {
    daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {sessions, 1 << 20}});
    const Running running(daemon);
    ask(rig.socket(), {{"command", "set"}, {"key", "engine_rpm"}, {"value", 900}});
    const nlohmann::json loud = status_when(rig.socket(), [](const nlohmann::json& s) {
      return is_recording(s) && s["meters"]["output_gain"] == 1 && s["meters"]["peak_db"] > -140;
    });
    first = loud["session"]["file"].get<std::string>();
    rig.write_rig("[mix]\ndrill_db = -3\n");
    CHECK(ask(rig.socket(), {{"command", "reload"}})["ok"] == true);
    const nlohmann::json again = status_when(rig.socket(), [&](const nlohmann::json& s) {
      return is_recording(s) && s["session"]["file"] != first.string() && s["meters"]["output_gain"] == 1;
    });
    CHECK(again["meters"]["output_gain"] == 1);
    second = again["session"]["file"].get<std::string>();
  }
  const std::vector<float> before = gains_of_session(first), after = gains_of_session(second);
  CHECK(before.back() == 0);
  CHECK(*std::max_element(before.begin(), before.end()) == 1);
  CHECK(after.front() == 0);
  CHECK(*std::max_element(after.begin(), after.end()) == 1);
  CHECK(after.back() == 0);  // the daemon's end
  CHECK(session::SessionStates(first).ended_in_order());
  CHECK(session::SessionStates(second).ended_in_order());
}

TEST_CASE("In silence a session that is half full ends, and the next begins where nobody hears it") {
  const SmallRig rig;
  const KeptLog log;  // of all that is said below
  const std::uintmax_t share = 10000;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {rig.folder.path / "sessions", 4 * share}});
  const Running running(daemon);
  nlohmann::json told = status_when(rig.socket(), is_recording);
  const std::string first = told["session"]["file"];
  while (told["session"]["bytes"] <= share / 2) {
    for (int i = 0; i < 20; ++i)
      ask(rig.socket(), {{"command", "set"}, {"key", "rod_count"}, {"value", 1 + i % 2}});
    const std::uint64_t before = told["session"]["bytes"];
    told = status_when(rig.socket(), [&](const nlohmann::json& s) { return s["session"]["bytes"] > before; });
    REQUIRE(told["session"]["file"] == first);
  }
  CHECK(told["session"]["bytes"] < share);
  const auto next = [&](const nlohmann::json& s) { return s["session"]["file"] != first; };
  CHECK(next(status_when(rig.socket(), next)));
}
