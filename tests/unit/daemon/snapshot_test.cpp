// What a running daemon tells of itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "daemon/running_daemon.hpp"
#include "rigsound/monotonic_time.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    lines.push_back(text.substr(start, end - start));
  return lines;
}

double value_of(const std::string& metrics, const std::string& series) {
  for (const std::string& line : lines_of(metrics))
    if (line.rfind(series + " ", 0) == 0) return std::stod(line.substr(series.size() + 1));
  return -1;
}

std::string metrics(const SmallRig& rig) {
  return ask(rig.socket(), {{"command", "metrics"}})["text"].get<std::string>();
}

constexpr const char* kTwoLinks =
    "[[modbus]]\nrole = \"server\"\ntransport = \"tcp\"\naddress = \"127.0.0.1:9\"\nunit = 1\n"
    "[modbus.signals]\nrock = { table = \"holding\", address = 0 }\n"
    "[[modbus]]\nrole = \"client\"\ntransport = \"tcp\"\naddress = \"127.0.0.1:9\"\nunit = 2\n"
    "[modbus.signals]\nrod_count = { table = \"holding\", address = 0 }\n";

}  // namespace

TEST_CASE("Two links to one address have two names, and no series comes twice") {
  const SmallRig rig;
  rig.write_rig(kTwoLinks);
  const double begun_s = monotonic_s();
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  const Running running(daemon);
  const nlohmann::json buses = status(rig.socket())["buses"];
  REQUIRE(buses.size() == 2);
  CHECK(buses[0]["name"] == "modbus 127.0.0.1:9");
  CHECK(buses[1]["name"] == "modbus 127.0.0.1:9 #2");
  std::vector<std::string> series;
  for (const std::string& line : lines_of(metrics(rig)))
    if (line[0] != '#') series.push_back(line.substr(0, line.rfind(' ')));
  std::sort(series.begin(), series.end());
  CHECK(series.size() > 100);
  CHECK(std::adjacent_find(series.begin(), series.end()) == series.end());
  const nlohmann::json audio = status(rig.socket())["audio"];
  CHECK(audio["block_ms"].get<double>() == doctest::Approx(64 / 48.0));
  CHECK(audio["block_mean_us"] > 0);
  CHECK(audio["block_worst_us"] >= audio["block_mean_us"]);
  const double uptime_s = status(rig.socket())["uptime_s"];
  CHECK(audio["block_worst_us"].get<double>() < 1e6 * uptime_s);
  CHECK(uptime_s > 0);
  CHECK(uptime_s <= monotonic_s() - begun_s);
}

TEST_CASE("A loud moment between two scrapes is in the second, and in no other") {
  const SmallRig rig;
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}, config::Buses::kLeftOut});
  const Running running(daemon);
  const auto set = [&](const char* key, double value) {
    REQUIRE(ask(rig.socket(), {{"command", "set"}, {"key", key}, {"value", value}})["ok"] == true);
  };
  const auto quiet = [](const nlohmann::json& s) { return s["meters"]["peak_db"] == -200; };
  const char* peak = "rigsound_peak_since_scrape_ratio";
  status_when(rig.socket(), quiet);
  metrics(rig);
  set("feed_pressure_bar", 90);
  status_when(rig.socket(), [&](const nlohmann::json& s) { return !quiet(s); });
  set("percussion", 0);
  CHECK(quiet(status_when(rig.socket(), quiet)));  // the status has forgotten it, the scrape has not
  CHECK(value_of(metrics(rig), peak) > 0);
  status_when(rig.socket(), quiet);
  CHECK(value_of(metrics(rig), peak) == 0);
}

TEST_CASE("A calibrated rig knows how loud it is, and turns itself down before its limit") {
  const SmallRig rig;
  rig.write_rig("[mix]\ndb_spl_at_0dbfs = 160\n[safety]\nmax_laeq_db = 40\n");
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}, config::Buses::kLeftOut});
  const Running running(daemon);
  CHECK(status(rig.socket())["exposure"]["lex_8h_db"] == 0);
  ask(rig.socket(), {{"command", "set"}, {"key", "engine_rpm"}, {"value", 1500}});
  const auto turned_down = [](const nlohmann::json& s) {
    return s["exposure"]["turned_down_db"] > 3 &&
           s["meters"]["output_gain"] < 0.9;  // a tenth of a second later
  };
  const nlohmann::json loud = status_when(rig.socket(), turned_down);
  CHECK(loud["exposure"]["turned_down_db"] > 3);
  CHECK(loud["exposure"]["lex_8h_db"] > 0);
  CHECK(loud["exposure"]["lc_peak_db"] > loud["exposure"]["laf_db"]);
  CHECK(loud["meters"]["output_gain"] < 0.9);
  CHECK(value_of(metrics(rig), "rigsound_exposure_turned_down_decibels") > 3);
  ask(rig.socket(), {{"command", "set"}, {"key", "engine_rpm"}, {"value", 0}});
  status_when(rig.socket(), [](const nlohmann::json& s) { return s["meters"]["peak_db"] == -200; });
  const nlohmann::json reset = ask(rig.socket(), {{"command", "exposure_reset"}});
  CHECK(reset["exposure"]["lex_8h_db"] == 0);
  CHECK(reset["exposure"]["lc_peak_db"] == 0);
}
