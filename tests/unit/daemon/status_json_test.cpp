// Every key of the status, with the figure that belongs to it.
#include "snapshot_json.hpp"

#include <doctest/doctest.h>

#include "daemon/telling_snapshot.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using namespace rigsound::test;

namespace {

nlohmann::json told(const Snapshot& snapshot) { return nlohmann::json::parse(status_json(snapshot).dump()); }

}  // namespace

TEST_CASE("The status tells the card, the time a block takes and its share of the block") {
  Snapshot s = telling_snapshot();
  CHECK(told(s)["audio"] ==
        nlohmann::json::parse(R"({"playing": true, "card": "hw:0", "scheduling": "SCHED_FIFO 70",
      "blocks": 1000, "block_ms": 2.0, "block_mean_us": 500.0, "block_worst_us": 1000.0, "load": 0.25,
      "deadline_misses": 21, "clock_jumps": 25, "skipped_blocks": 26, "xruns": 11, "suspends": 12,
      "bad_states": 13, "short_writes": 14, "interruptions": 15, "losses": 16})"));
  s.block_s = s.block_mean_s = 0;
  CHECK(told(s)["audio"]["load"] == 0);
}

TEST_CASE("The status tells levels in dB of full scale, and -200 dB for silence") {
  Snapshot s = telling_snapshot();
  const nlohmann::json meters = told(s)["meters"];
  const auto db = [](const nlohmann::json& value) {
    return doctest::Approx(value.get<double>()).epsilon(1e-5);
  };
  CHECK(-6.0206 == db(meters["peak_db"]));
  CHECK(-12.0412 == db(meters["rms_db"]));
  CHECK(-2.49877 == db(meters["limiter_db"]));
  CHECK(-18.0618 == db(meters["diesel"]["peak_db"]));
  CHECK(-24.0824 == db(meters["diesel"]["rms_db"]));
  CHECK(meters["output_gain"] == 0.875);
  CHECK(meters["lost_clicks"] == 23);
  CHECK(meters["dropped_chunks"] == 24);
  const nlohmann::json levels = told(s)["booms"][0]["levels"];
  CHECK(-30.103 == db(levels["drill"]["peak_db"]));
  CHECK(-42.1442 == db(levels["string"]["peak_db"]));
  s.output = {0, 0};
  CHECK(told(s)["meters"]["peak_db"] == -200);
  CHECK(told(s)["meters"]["rms_db"] == -200);
}

TEST_CASE("The status tells the exposure and the session, each figure under its key") {
  const nlohmann::json status = told(telling_snapshot());
  CHECK(status["exposure"] == nlohmann::json::parse(R"({"laf_db": 71.0, "las_db": 72.0, "laeq_1min_db": 73.0,
      "lex_8h_db": 74.0, "lc_peak_db": 75.0, "since_s": 76.0, "turned_down_db": 77.0})"));
  CHECK(status["session"] == nlohmann::json::parse(R"({"file": "run.rigs", "recording": true, "bytes": 4096,
      "problem": "disk full", "lost_records": 22})"));
  CHECK(status["ok"] == true);
  CHECK(status["version"] == "1.2.3");
  CHECK(status["rig"] == "rig.toml");
  CHECK(status["uptime_s"] == 90);
  CHECK(status["muted"] == true);
  CHECK(status["paused"] == false);
  CHECK(status["no_buses"] == false);
  CHECK(status["reloads"] == 31);
  CHECK(status["failed_reloads"] == 32);
  CHECK(status["lost_log_entries"] == 33);
}

TEST_CASE("The status tells signals, buses and booms, each figure under its key") {
  const nlohmann::json status = told(telling_snapshot());
  CHECK(status["signals"] == nlohmann::json::parse(R"([
      {"name": "engine_rpm", "value": 1500.0, "unit": "r/min", "validity": "valid", "age_s": 0.0, "word": "",
       "refused": 41, "last_refused": null, "clamped": 42},
      {"name": "rock", "value": 1.0, "unit": "", "validity": "manual", "age_s": null, "word": "marble",
       "refused": 43, "last_refused": 910.0, "clamped": 44},
      {"name": "rod_count", "value": 5.0, "unit": "", "validity": "never_seen", "age_s": null, "word": "",
       "refused": 0, "last_refused": null, "clamped": 0}])"));
  CHECK(status["buses"] == nlohmann::json::parse(R"([
      {"name": "can can0", "up": true, "problem": "", "frames_seen": 51, "frames_bad": 52},
      {"name": "udp :9", "up": false, "problem": "no route", "frames_seen": 53, "losses": 54}])"));
  const nlohmann::json& boom = status["booms"][0];
  CHECK(boom["hammering"] == true);
  CHECK(boom["situation"] == "open_rattling");
  CHECK(boom["feed_deviation"] == -1.5);
  CHECK(boom["rods"] == 3);
  CHECK(boom["rock"] == "slate");
  CHECK(boom["impacts_wanted_hz"] == 40);
  CHECK(boom["impacts_made_hz"] == 39);
  CHECK(boom["banks"][1] == nlohmann::json({{"name", "soft"}, {"share", 0.25}, {"rods", 0}, {"rock", ""}}));
}
