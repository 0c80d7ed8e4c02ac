// What a subscriber is told follows the status, and nothing is told twice.
#include "subscription.hpp"

#include <doctest/doctest.h>

#include "control_conversation.hpp"
#include "daemon/running_daemon.hpp"
#include "live_values.hpp"
#include "snapshot_json.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using namespace rigsound::test;

namespace {

Snapshot playing() {
  Snapshot s;
  s.uptime_s = 7;
  s.blocks = 1000;
  s.signals = {{"engine_rpm", "r/min", 1500, 0.01, "valid", "", 0, 0, {}},
               {"boom2.rattling", "", 2, 0.1, "valid", "open", 3, 0, 9}};
  s.buses = {{"can can0", true, "", {{"frames_seen", 7}}}};
  s.booms.resize(1);
  s.booms[0].name = "left";
  return s;
}

struct Subscribed {
  explicit Subscribed(const Json& request) : subscription(request) {}
  /// The change told now, or null when nothing is.
  nlohmann::json change(const Snapshot& s) {
    const std::string line = subscription.line(status_json(s), now_s += 1);
    if (line.empty()) return nullptr;
    REQUIRE(line.find('\n') == line.size() - 1);
    event = nlohmann::json::parse(line);
    state.merge_patch(event["change"]);
    return event["change"];
  }
  Subscription subscription;
  double now_s = 0;
  nlohmann::json event, state;
};

}  // namespace

TEST_CASE("A subscriber is told all at first, then what is other, and nothing when nothing is") {
  Subscribed client{Json::object()};
  Snapshot s = playing();
  const nlohmann::json all = client.change(s);
  CHECK(all["signals"]["engine_rpm"]["value"] == 1500);
  CHECK(all["signals"]["boom2.rattling"]["word"] == "open");
  CHECK(all["buses"]["can can0"] == nlohmann::json{{"up", true}, {"problem", ""}});
  CHECK(all["booms"]["left"]["situation"] == "underfeed");
  CHECK(client.event["event"] == "change");
  CHECK(client.event["missed"] == 0);

  s.blocks += 75;  // these grow by themselves
  s.uptime_s += 0.1;
  s.block_mean_s = 1e-5;
  s.signals[0].age_s = 0.02;
  s.session.bytes = 4000;
  s.buses[0].counters[0].count = 8;
  CHECK(client.change(s).is_null());

  s.signals[0].value = 1501;
  s.booms[0].situation = Situation::kOverfeed;
  s.muted = true;
  s.reloads = 1;
  s.signals[1].validity = "manual";
  CHECK(client.change(s) ==
        nlohmann::json{
            {"muted", true},
            {"signals", {{"engine_rpm", {{"value", 1501.0}}}, {"boom2.rattling", {{"validity", "manual"}}}}},
            {"booms", {{"left", {{"situation", "overfeed"}}}}},
            {"reloads", 1}});
  s.signals[1].last_refused.reset();
  s.buses.clear();
  CHECK(client.change(s) == nlohmann::json::parse(R"({"signals": {"boom2.rattling": {"last_refused": null}},
                                            "buses": {"can can0": null}})"));
  CHECK_FALSE(client.state["buses"].contains("can can0"));
  CHECK(client.state["booms"]["left"]["situation"] == "overfeed");
}

TEST_CASE("Topics choose parts of the status; levels of booms come with the meters") {
  Snapshot s = playing();
  Subscribed booms{Json{{"topics", {"booms"}}}}, meters{Json{{"topics", {"booms", "meters"}}}};
  const nlohmann::json all = booms.change(s);
  CHECK_FALSE(all.contains("signals"));
  CHECK_FALSE(all.contains("meters"));
  CHECK(all["muted"] == false);
  CHECK_FALSE(all["booms"]["left"].contains("levels"));
  CHECK(meters.change(s)["booms"]["left"].contains("levels"));
  s.booms[0].drill_level.peak = 0.5;
  s.output.peak = 0.5;
  CHECK(booms.change(s).is_null());
  CHECK(meters.change(s)["meters"]["peak_db"].get<double>() == doctest::Approx(-6.02).epsilon(0.001));
}

TEST_CASE("A subscription that cannot be is refused with what can") {
  const auto refusal = [](const Json& request) { return complaint([&] { Subscription{request}; }); };
  CHECK(refusal(Json{{"every_s", 0.01}}) == "every_s: is 0.01 s, expected 0.1...3600 s");
  CHECK(refusal(Json{{"topics", {"signal"}}}) == "topics: signal: is none, did you mean signals?");
  CHECK(refusal(Json{{"topics", Json::array()}}).rfind("topics: expected a list of audio, buses,", 0) == 0);
  CHECK(refusal(Json{{"topics", {7}}}).rfind("topics: 7: is none, expected", 0) == 0);
  CHECK(refusal(Json::object()) == "");
}

TEST_CASE("What a client was too slow for is counted, and covered by the next line") {
  Subscribed client{Json::object()};
  Snapshot s = playing();
  client.change(s);
  s.muted = true;
  client.subscription.miss(10);
  CHECK_FALSE(client.subscription.due(10.1));
  CHECK(client.subscription.due(10.2));
  client.subscription.miss(10.2);
  s.signals[0].value = 900;
  const nlohmann::json change = client.change(s);
  CHECK(client.event["missed"] == 2);
  CHECK(change["muted"] == true);
  CHECK(change["signals"]["engine_rpm"]["value"] == 900);
  s.muted = false;
  client.change(s);
  CHECK(client.event["missed"] == 0);
}

TEST_CASE("A daemon pushes mute, values by hand and reloads to who has subscribed, until that unsubscribes") {
  const SmallRig rig;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  const Running running(daemon);
  Line line(rig.socket());
  CHECK(line.ask({{"command", "subscribe"}, {"every_s", 0.1}, {"topics", {"signals", "booms"}}})["every_s"] ==
        0.1);
  nlohmann::json state = line.next()["change"];
  CHECK(state["muted"] == false);
  const auto follow_until = [&](const auto& holds) {
    while (!holds(state)) state.merge_patch(line.next()["change"]);
  };
  ask(rig.socket(), {{"command", "mute"}, {"on", true}});
  follow_until([](const nlohmann::json& s) { return s["muted"] == true; });
  ask(rig.socket(), {{"command", "set"}, {"key", "feed_pressure_bar"}, {"value", 160}});
  follow_until([](const nlohmann::json& s) {
    return s["signals"]["feed_pressure_bar"]["validity"] == "manual" &&
           s["booms"]["boom"]["situation"] == "overfeed";
  });
  ask(rig.socket(), {{"command", "reload"}});
  follow_until([](const nlohmann::json& s) { return s["reloads"] == 1; });
  line.say({{"command", "unsubscribe"}});
  nlohmann::json said = line.next();
  while (said.contains("event")) said = line.next();
  CHECK(said == nlohmann::json{{"ok", true}, {"was_subscribed", true}});
  CHECK(line.ask({{"command", "unsubscribe"}})["was_subscribed"] == false);
}
