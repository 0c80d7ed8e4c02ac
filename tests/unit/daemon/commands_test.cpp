#include "commands.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rigsound/machine/signal_board.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

struct TwoBooms : DaemonControl {
  Snapshot snapshot() const override {
    Snapshot s;
    s.muted = muted;
    s.exposure = exposure;
    s.signals = {{"engine_rpm", "r/min", 1500, 0.01, "valid", "", 0, 0, {}},
                 {"boom2.rod_count", "", 1, -1, "never_seen", "", 0, 0, {}},
                 {"rattling", "", 2, -1, "manual", "open", 0, 0, {}},
                 {"feed_pressure_bar", "bar", 300, 3, "out_of_range", "", 12, 4, 910}};
    s.buses = {{"can \"0\"", true, "", {{"frames_seen", 7}, {"frames_used", 5}}}};
    s.output = {0.5, 0.1};
    s.booms.resize(2);
    s.booms[0].name = "left";
    s.booms[1].name = "right";
    for (std::size_t b = 0; b < 2; ++b) s.booms[b].controls = controls_[b];
    s.booms[1].situation = Situation::kOverfeed;
    s.booms[1].feed_deviation = 1.5;
    s.booms[1].banks = {{"hard", 0.75, 6, "granite"}, {"hard", 0.125, 6, "granite"}, {"soft", 0.125, 0, ""}};
    s.booms[1].impacts_wanted_hz = 40;
    s.booms[1].tool = "string";
    s.booms[1].tool_level = {0.25, 0.125};
    return s;
  }
  Snapshot scrape() override {
    Snapshot s = snapshot();
    s.output.peak = 0.75;
    return s;
  }
  std::uint64_t ask_reload() override { return reloads.ask(); }
  const ReloadResult* reload_result(std::uint64_t number) const override { return reloads.result(number); }
  void set_muted(bool on) override { muted = on; }
  void reset_exposure() override { exposure = ExposureSnapshot{}; }
  std::vector<std::string> boom_names() const override { return {"left", "right"}; }
  DrillControls controls(int boom) const override { return controls_[boom]; }
  void set_control(int boom, const ControlInfo& control, double value) override {
    controls_[boom].*control.field = static_cast<float>(value);
  }
  std::vector<std::string> rock_names() const override { return {"granite", "marble"}; }
  bool holds(SignalId id) const override { return board.entry(id).by_hand; }
  void hold(SignalId id, double value) override { board.hold(id, value); }
  void release(SignalId id) override { board.release(id); }

  double held(Signal s, int boom = 0) const {
    const SignalBoard::Entry& entry = board.entry({s, static_cast<std::uint8_t>(boom)});
    return entry.by_hand ? entry.hand_value : -99;
  }

  ClientState client;
  ReloadQueue reloads;
  std::optional<ExposureSnapshot> exposure;
  bool muted = false;
  DrillControls controls_[2];
  SignalBoard board;
};

nlohmann::json asked(TwoBooms& daemon, const std::string& request) {
  const std::string line = answer(request, daemon, daemon.client);
  REQUIRE(line.back() == '\n');
  REQUIRE(line.find('\n') == line.size() - 1);
  return nlohmann::json::parse(line);
}

std::string refusal(TwoBooms& daemon, const std::string& request) {
  const nlohmann::json answer = asked(daemon, request);
  CHECK_FALSE(answer["ok"].get<bool>());
  return answer.value("error", "");
}

/// A request to set `key` to `value`, a JSON text.
std::string setting(const std::string& key, const std::string& value) {
  return R"({"command":"set","key":")" + key + R"(","value":)" + value + "}";
}

std::string releasing(const std::string& key) { return R"({"command":"release","key":")" + key + R"("})"; }

}  // namespace

TEST_CASE("set reaches one boom or all of them, and only within its range") {
  TwoBooms daemon;
  CHECK(asked(daemon, R"({"command":"set","key":"left.mean_frequency_hz","value":42})")["ok"]);
  CHECK(daemon.controls_[0].mean_frequency_hz == 42);
  CHECK(daemon.controls_[1].mean_frequency_hz == 0);
  CHECK(asked(daemon, R"({"command":"set","key":"decay_factor","value":2})")["ok"]);
  CHECK(daemon.controls_[0].decay_factor == 2);
  CHECK(daemon.controls_[1].decay_factor == 2);
  CHECK(asked(daemon, R"({"command":"set","key":"mean_frequency_hz","value":0})")["ok"]);
  for (const char* bad :
       {R"({"command":"set","key":"decay_factor","value":11})",
        R"({"command":"set","key":"decay_factor","value":"x"})",
        R"({"command":"set","key":"mean_frequency_hz","value":0.5})",
        R"({"command":"set","key":"volume","value":1})",
        R"({"command":"set","key":"middle.decay_factor","value":1})", R"({"command":"set"})"}) {
    const nlohmann::json refused = asked(daemon, bad);
    CHECK_FALSE(refused["ok"].get<bool>());
    CHECK(!refused["error"].get<std::string>().empty());
  }
  CHECK(daemon.controls_[0].decay_factor == 2);
}

TEST_CASE("set holds a signal of one boom, of all, or of the rig, by number or word") {
  TwoBooms daemon;
  CHECK(asked(daemon, setting("feed_pressure_bar", "130"))["set"].size() == 2);
  CHECK(daemon.held(Signal::kFeedPressureBar, 0) == 130);
  CHECK(daemon.held(Signal::kFeedPressureBar, 1) == 130);
  const nlohmann::json answer = asked(daemon, setting("right.rattling", "\"open\""));
  CHECK(answer["set"][0]["name"] == "right.rattling");
  CHECK(answer["set"][0]["manual"] == true);
  CHECK(daemon.held(Signal::kRattling, 0) == -99);
  CHECK(daemon.held(Signal::kRattling, 1) == 2);
  asked(daemon, setting("right.rattling", "1"));
  CHECK(daemon.held(Signal::kRattling, 1) == 1);
  CHECK(asked(daemon, setting("engine_rpm", "1500"))["set"][0]["name"] == "engine_rpm");
  CHECK(daemon.held(Signal::kEngineRpm) == 1500);
  asked(daemon, setting("left.rock", "\"marble\""));
  CHECK(daemon.held(Signal::kRock) == 1);
  asked(daemon, setting("percussion_rate_hz", "0"));
  CHECK(daemon.held(Signal::kPercussionRateHz) == 0);
}

TEST_CASE(
    "a value that a signal cannot have is refused with what it can, and a misspelt word with the one meant") {
  TwoBooms daemon;
  CHECK(refusal(daemon, setting("feed_pressure_bar", "400")) ==
        "feed_pressure_bar: is 400 bar, expected 0...300 bar");
  CHECK(refusal(daemon, setting("rod_count", "2.5")) == "rod_count: is 2.5, expected a whole number, 1...20");
  CHECK(refusal(daemon, setting("percussion_rate_hz", "3")) ==
        "percussion_rate_hz: is 3 Hz, expected 0 or 5...120 Hz");
  CHECK(refusal(daemon, setting("rattling", "\"opn\"")) == "rattling: is opn, did you mean open?");
  CHECK(refusal(daemon, setting("rattling", "\"sideways\"")) ==
        "rattling: is sideways, expected none, closed, open, or 0...2");
  CHECK(refusal(daemon, setting("feed_pressure_bar", "\"high\"")) ==
        "feed_pressure_bar: is high, expected a number, 0...300 bar");
  CHECK(refusal(daemon, setting("feed_presure_bar", "1")) ==
        "feed_presure_bar: is no signal and no control, did you mean feed_pressure_bar?");
  CHECK(refusal(daemon, setting("rigth.rattling", "1")) ==
        "rigth: is no boom of the rig, did you mean right?");
  CHECK(refusal(daemon, setting("left.engine_rpm", "1")) ==
        "left.engine_rpm: is a signal of the whole rig, expected engine_rpm without a boom");
  CHECK(refusal(daemon, setting("rock", "\"slate\"")).find("granite, marble") != std::string::npos);
  for_each_signal(2, [&](SignalId id) { CHECK_FALSE(daemon.holds(id)); });
}

TEST_CASE("every signal and every control of the lists can be set to its ends and released") {
  TwoBooms daemon;
  for (const SignalInfo& signal : signal_table())
    for (const double value : {signal.min, signal.max}) {
      const std::string name(signal.name);
      CHECK(asked(daemon, setting(name, nlohmann::json(value).dump()))["ok"] == true);
      CHECK(daemon.held(*signal_by_name(name)) == value);
    }
  for (const ControlInfo& control : control_table())
    CHECK(asked(daemon, setting(std::string(control.name), nlohmann::json(control.max).dump()))["ok"] ==
          true);
  const nlohmann::json released = asked(daemon, releasing("all"))["released"];
  CHECK(released.size() == 4 + 2 * 12 + 2 * control_table().size());
  for_each_signal(2, [&](SignalId id) { CHECK_FALSE(daemon.holds(id)); });
  for (const ControlInfo& control : control_table())
    CHECK(daemon.controls_[1].*control.field == static_cast<float>(control.neutral));
  CHECK(asked(daemon, releasing("all"))["released"].empty());
}

TEST_CASE("release lets go of one signal of one boom, and leaves the others") {
  TwoBooms daemon;
  asked(daemon, setting("feed_pressure_bar", "130"));
  asked(daemon, setting("engine_rpm", "900"));
  CHECK(asked(daemon, releasing("left.feed_pressure_bar"))["released"] ==
        nlohmann::json({"left.feed_pressure_bar"}));
  CHECK(daemon.held(Signal::kFeedPressureBar, 0) == -99);
  CHECK(daemon.held(Signal::kFeedPressureBar, 1) == 130);
  CHECK(daemon.held(Signal::kEngineRpm) == 900);
  CHECK(refusal(daemon, releasing("volume")).find("volume: is no signal") == 0);
}

TEST_CASE("Nonsense is answered, never obeyed") {
  TwoBooms daemon;
  for (const char* bad : {"", "{", "[]", "42", "\"status\"", "{\"command\":1}", "{\"command\":\"fly\"}",
                          "\xff\xfe", "{\"command\":\"mute\",\"on\":\"yes\"}"})
    CHECK_FALSE(asked(daemon, bad)["ok"].get<bool>());
  CHECK_FALSE(daemon.muted);
}

TEST_CASE("mute turns over, or goes where it is told") {
  TwoBooms daemon;
  CHECK(asked(daemon, R"({"command":"mute"})")["muted"] == true);
  CHECK(asked(daemon, R"({"command":"mute","on":true})")["muted"] == true);
  CHECK(asked(daemon, R"({"command":"mute"})")["muted"] == false);
}

TEST_CASE("exposure begins again where the output is calibrated") {
  TwoBooms daemon;
  CHECK(asked(daemon, R"({"command": "status"})")["exposure"].is_null());
  CHECK(asked(daemon, R"({"command": "metrics"})")["text"].get<std::string>().find("exposure") ==
        std::string::npos);
  CHECK(asked(daemon, R"({"command": "exposure_reset"})")["error"].get<std::string>().find(
            "db_spl_at_0dbfs") != std::string::npos);
  daemon.exposure = ExposureSnapshot{71, 70, 69, 58.5, 101, 3600, 1.5};
  const nlohmann::json told = asked(daemon, R"({"command": "status"})")["exposure"];
  CHECK(told["laf_db"] == 71);
  CHECK(told["lex_8h_db"] == 58.5);
  CHECK(told["turned_down_db"] == 1.5);
  CHECK(asked(daemon, R"({"command": "metrics"})")["text"].get<std::string>().find(
            "\nrigsound_exposure_8h_decibels 58.5\n") != std::string::npos);
  const nlohmann::json reset = asked(daemon, R"({"command": "exposure_reset"})");
  CHECK(reset["ok"] == true);
  CHECK(reset["exposure"]["lex_8h_db"] == 0);
}

TEST_CASE("reload answers when it is over: why not, and what only a restart can change") {
  TwoBooms daemon;
  const auto reload = [&](ReloadResult result) {
    CHECK(answer(R"({"command":"reload"})", daemon, daemon.client).empty());
    CHECK(late_answer(daemon, daemon.client).empty());
    daemon.reloads.begin();
    CHECK(late_answer(daemon, daemon.client).empty());
    daemon.reloads.finish(std::move(result));
    nlohmann::json said = nlohmann::json::parse(late_answer(daemon, daemon.client));
    CHECK(late_answer(daemon, daemon.client).empty());
    return said;
  };
  CHECK(reload({"", {"audio.rate: 48000, wanted 44100"}})["not_applied"].size() == 1);
  CHECK(reload({"rig.toml:3: mix.dril_db: unknown key", {}})["error"] ==
        "rig.toml:3: mix.dril_db: unknown key");
}

TEST_CASE("status carries signals with their age, a signal never seen has none") {
  TwoBooms daemon;
  const nlohmann::json status = asked(daemon, R"({"command":"status"})");
  CHECK(status["signals"][0]["value"] == 1500);
  CHECK(status["signals"][0]["age_s"] == doctest::Approx(0.01));
  CHECK(status["signals"][1]["age_s"].is_null());
  CHECK(status["buses"][0]["frames_used"] == 5);
}

TEST_CASE("status says why it sounds like this: situation, banks, impacts, levels, what was refused") {
  TwoBooms daemon;
  const nlohmann::json status = asked(daemon, R"({"command":"status"})");
  const nlohmann::json& right = status["booms"][1];
  CHECK(right["situation"] == "overfeed");
  CHECK(right["feed_deviation"] == 1.5);
  CHECK(right["banks"][0] ==
        nlohmann::json({{"name", "hard"}, {"share", 0.75}, {"rods", 6}, {"rock", "granite"}}));
  CHECK(right["impacts_wanted_hz"] == 40);
  CHECK(right["levels"]["string"]["peak_db"].get<double>() == doctest::Approx(-12.04).epsilon(0.001));
  CHECK_FALSE(right["levels"].contains("tool"));
  CHECK_FALSE(status["booms"][0]["levels"].contains("string"));
  CHECK(right["decay_factor"] == 1);
  CHECK(status["signals"][2]["word"] == "open");
  CHECK(status["signals"][2]["validity"] == "manual");
  CHECK(status["signals"][3]["refused"] == 12);
  CHECK(status["signals"][3]["clamped"] == 4);
  CHECK(status["signals"][3]["last_refused"] == 910);
  CHECK(status["meters"]["peak_db"].get<double>() == doctest::Approx(-6.02).epsilon(0.001));
}

TEST_CASE("Metrics keep the rules of OpenMetrics") {
  TwoBooms daemon;
  const std::string text = asked(daemon, R"({"command":"metrics"})")["text"];
  CHECK(text.substr(text.size() - 6) == "# EOF\n");
  CHECK(text.find("rigsound_bus_frames_seen_total{bus=\"can \\\"0\\\"\"} 7") != std::string::npos);
  CHECK(text.find("rigsound_signal_age_seconds{signal=\"engine_rpm\"} 0.01") != std::string::npos);
  CHECK(
      text.find("rigsound_signal_state{signal=\"boom2.rod_count\",rigsound_signal_state=\"never_seen\"} 1") !=
      std::string::npos);
  CHECK(text.find("rigsound_peak_since_scrape_ratio 0.75") != std::string::npos);  // of the scrape
  CHECK(text.find("rigsound_signal_value{signal=\"engine_rpm\",unit=\"r/min\"} 1500") != std::string::npos);
  CHECK(text.find("rigsound_signal_value{signal=\"rattling\",unit=\"\"} 2") != std::string::npos);  // by hand
  CHECK(text.find("rigsound_signal_value{signal=\"boom2.rod_count\"") == std::string::npos);  // never said
  CHECK(text.find("rigsound_signal_refused_total{signal=\"feed_pressure_bar\"} 12") != std::string::npos);
  CHECK(text.find("rigsound_boom_situation{boom=\"right\",rigsound_boom_situation=\"overfeed\"} 1") !=
        std::string::npos);
  CHECK(
      text.find(
          "rigsound_boom_bank_share_ratio{boom=\"right\",bank=\"hard\",rods=\"6\",rock=\"granite\"} 0.875") !=
      std::string::npos);
  CHECK(text.find("{boom=\"right\",bank=\"soft\",rods=\"any\",rock=\"any\"} 0.125") != std::string::npos);
  // Every sample belongs to the family announced last before it, and no family comes twice.
  std::string family;
  std::vector<std::string> families, series;
  std::size_t start = 0;
  for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    const std::string line = text.substr(start, end - start);
    if (line.rfind("# TYPE ", 0) == 0) {
      family = line.substr(7, line.find(' ', 7) - 7);
      CHECK(std::count(families.begin(), families.end(), family) == 0);
      families.push_back(family);
    } else if (line[0] != '#') {
      CHECK(line.rfind(family, 0) == 0);
      series.push_back(line.substr(0, line.rfind(' ')));
    }
  }
  CHECK(families.size() > 30);
  std::sort(series.begin(), series.end());
  CHECK(std::adjacent_find(series.begin(), series.end()) == series.end());
}
