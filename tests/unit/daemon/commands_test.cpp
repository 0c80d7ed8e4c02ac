#include "commands.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

using namespace rigsound;
using namespace rigsound::daemon;
using Json = nlohmann::json;

namespace {

struct TwoBooms : DaemonControl {
  Snapshot snapshot() const override {
    Snapshot s;
    s.muted = muted;
    s.signals = {{"engine_rpm", "r/min", 1500, 0.01, "valid"}, {"boom2.rod_count", "", 1, -1, "never_seen"}};
    s.buses = {{"can \"0\"", true, "", {{"frames_seen", 7}, {"frames_used", 5}}}};
    s.booms = {{"left", controls_[0]}, {"right", controls_[1]}};
    return s;
  }
  ReloadResult reload() override { return reloaded; }
  void set_muted(bool on) override { muted = on; }
  std::vector<std::string> boom_names() const override { return {"left", "right"}; }
  DrillControls controls(int boom) const override { return controls_[boom]; }
  void set_controls(int boom, const DrillControls& c) override { controls_[boom] = c; }

  ReloadResult reloaded;
  bool muted = false;
  DrillControls controls_[2];
};

Json ask(TwoBooms& daemon, const std::string& request) {
  const std::string line = answer(request, daemon);
  REQUIRE(line.back() == '\n');
  REQUIRE(line.find('\n') == line.size() - 1);
  return Json::parse(line);
}

}  // namespace

TEST_CASE("set reaches one boom or all of them, and only within its range") {
  TwoBooms daemon;
  CHECK(ask(daemon, R"({"command":"set","key":"left.mean_frequency_hz","value":42})")["ok"]);
  CHECK(daemon.controls_[0].mean_frequency_hz == 42);
  CHECK(daemon.controls_[1].mean_frequency_hz == 0);
  CHECK(ask(daemon, R"({"command":"set","key":"decay_factor","value":2})")["ok"]);
  CHECK(daemon.controls_[0].decay_factor == 2);
  CHECK(daemon.controls_[1].decay_factor == 2);
  CHECK(ask(daemon, R"({"command":"set","key":"mean_frequency_hz","value":0})")["ok"]);
  for (const char* bad :
       {R"({"command":"set","key":"decay_factor","value":11})",
        R"({"command":"set","key":"decay_factor","value":"x"})",
        R"({"command":"set","key":"mean_frequency_hz","value":0.5})",
        R"({"command":"set","key":"volume","value":1})",
        R"({"command":"set","key":"middle.decay_factor","value":1})", R"({"command":"set"})"}) {
    const Json refused = ask(daemon, bad);
    CHECK_FALSE(refused["ok"].get<bool>());
    CHECK(!refused["error"].get<std::string>().empty());
  }
  CHECK(daemon.controls_[0].decay_factor == 2);
}

TEST_CASE("Nonsense is answered, never obeyed") {
  TwoBooms daemon;
  for (const char* bad : {"", "{", "[]", "42", "\"status\"", "{\"command\":1}", "{\"command\":\"fly\"}",
                          "\xff\xfe", "{\"command\":\"mute\",\"on\":\"yes\"}"})
    CHECK_FALSE(ask(daemon, bad)["ok"].get<bool>());
  CHECK_FALSE(daemon.muted);
}

TEST_CASE("mute turns over, or goes where it is told") {
  TwoBooms daemon;
  CHECK(ask(daemon, R"({"command":"mute"})")["muted"] == true);
  CHECK(ask(daemon, R"({"command":"mute","on":true})")["muted"] == true);
  CHECK(ask(daemon, R"({"command":"mute"})")["muted"] == false);
}

TEST_CASE("reload says why not, and what only a restart can change") {
  TwoBooms daemon;
  daemon.reloaded.not_applied = {"audio.rate: 48000, wanted 44100"};
  CHECK(ask(daemon, R"({"command":"reload"})")["not_applied"].size() == 1);
  daemon.reloaded.error = "rig.toml:3: mix.dril_db: unknown key";
  CHECK(ask(daemon, R"({"command":"reload"})")["error"] == "rig.toml:3: mix.dril_db: unknown key");
}

TEST_CASE("status carries signals with their age, a signal never seen has none") {
  TwoBooms daemon;
  const Json status = ask(daemon, R"({"command":"status"})");
  CHECK(status["signals"][0]["value"] == 1500);
  CHECK(status["signals"][0]["age_s"] == doctest::Approx(0.01));
  CHECK(status["signals"][1]["age_s"].is_null());
  CHECK(status["buses"][0]["frames_used"] == 5);
}

TEST_CASE("Metrics keep the rules of OpenMetrics") {
  TwoBooms daemon;
  const std::string text = ask(daemon, R"({"command":"metrics"})")["text"];
  CHECK(text.substr(text.size() - 6) == "# EOF\n");
  CHECK(text.find("rigsound_bus_frames_seen_total{bus=\"can \\\"0\\\"\"} 7") != std::string::npos);
  CHECK(text.find("rigsound_signal_age_seconds{signal=\"engine_rpm\"} 0.01") != std::string::npos);
  CHECK(
      text.find("rigsound_signal_state{signal=\"boom2.rod_count\",rigsound_signal_state=\"never_seen\"} 1") !=
      std::string::npos);
  // Every sample belongs to the family announced last before it, and no family comes twice.
  std::string family;
  std::vector<std::string> families;
  std::size_t start = 0;
  for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    const std::string line = text.substr(start, end - start);
    if (line.rfind("# TYPE ", 0) == 0) {
      family = line.substr(7, line.find(' ', 7) - 7);
      CHECK(std::count(families.begin(), families.end(), family) == 0);
      families.push_back(family);
    } else if (line[0] != '#') {
      CHECK(line.rfind(family, 0) == 0);
    }
  }
  CHECK(families.size() > 20);
}
