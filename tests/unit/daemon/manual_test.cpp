// By hand, without a bus: sound, marks in the status, and a session that says who said what.
#include <doctest/doctest.h>

#include "daemon/running_daemon.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

nlohmann::json signal_of(const nlohmann::json& status, const std::string& name) {
  for (const nlohmann::json& signal : status["signals"])
    if (signal["name"] == name) return signal;
  return {};
}

void set(const SmallRig& rig, const std::string& key, const nlohmann::json& value) {
  CHECK(ask(rig.socket(), {{"command", "set"}, {"key", key}, {"value", value}})["ok"] == true);
}

constexpr const char* kAbsentBuses =
    "[[boom]]\n[[boom]]\n[[can]]\ninterface = \"gone7\"\ndbc = \"gone.dbc\"\n[can.signals]\nengine_rpm = "
    "\"A.B\"\n";

}  // namespace

TEST_CASE("A rig whose bus and DBC do not exist drills by hand, is marked so, and its session says it") {
  const SmallRig rig;
  rig.write_rig(kAbsentBuses);
  const fs::path sessions = rig.folder.path / "sessions";
  const std::string file = (rig.folder.path / "rig.toml").string();
  CHECK_FALSE(complaint([&] { const daemon::Daemon daemon({file, {}}); }).empty());
  {
    daemon::Daemon daemon({file, {sessions, 1 << 20}, config::Buses::kLeftOut});
    const Running running(daemon);
    const nlohmann::json silent = status(rig.socket());
    CHECK(silent["no_buses"] == true);
    CHECK(silent["buses"].empty());
    CHECK(silent["audio"]["playing"] == false);  // device null
    set(rig, "boom2.feed_pressure_bar", 150);
    set(rig, "engine_rpm", 1500);
    const nlohmann::json loud = status_when(rig.socket(), [](const nlohmann::json& s) {
      return s["booms"][1]["levels"]["drill"]["rms_db"] > -140 && s["booms"][1]["feed_deviation"] > 0.99;
    });
    CHECK(loud["booms"][1]["levels"]["drill"]["rms_db"] > -140);
    CHECK(loud["booms"][0]["levels"]["drill"]["rms_db"] == -200);
    CHECK(loud["booms"][1]["situation"] == "overfeed");
    CHECK(loud["booms"][1]["feed_deviation"].get<double>() == doctest::Approx(1).epsilon(0.01));
    CHECK(loud["booms"][1]["banks"][0]["name"] == "a");
    CHECK(loud["meters"]["diesel"]["rms_db"] > -140);
    CHECK(signal_of(loud, "boom2.feed_pressure_bar")["validity"] == "manual");
    CHECK(signal_of(loud, "feed_pressure_bar")["validity"] == "never_seen");
    CHECK(signal_of(loud, "engine_rpm")["value"] == 1500);
    CHECK(signal_of(loud, "engine_rpm")["word"] == "");
    ask(rig.socket(), {{"command", "release"}, {"key", "boom2.feed_pressure_bar"}});
    status_when(rig.socket(), [](const nlohmann::json& s) { return s["booms"][1]["feed_deviation"] < 0; });
    set(rig, "rattling", "open");
    const nlohmann::json rattling = status_when(
        rig.socket(), [](const nlohmann::json& s) { return signal_of(s, "rattling")["value"] == 2; });
    CHECK(signal_of(rattling, "rattling")["word"] == "open");
    CHECK(ask(rig.socket(), {{"command", "reload"}})["ok"] == true);  // without the buses again
    CHECK(status(rig.socket())["buses"].empty());
    CHECK(signal_of(status(rig.socket()), "engine_rpm")["validity"] == "manual");
  }
  bool held = false, released = false;
  const InputFile recorded(session::newest_session(sessions), "session");
  session::SessionChanges told(recorded);
  for (session::Change change; told.next(change);) {
    const bool now = is_by_hand(change.state, {Signal::kFeedPressureBar, 1});
    held = held || (now && change.state.boom[1].feed_pressure_bar == 150);
    released = released || (held && !now && change.state.boom[1].feed_pressure_bar == 0);
  }
  CHECK(held);
  CHECK(released);
}
