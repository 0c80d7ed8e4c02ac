// Every series of the metrics page, with the figure that belongs to it.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "daemon/telling_snapshot.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using namespace rigsound::test;

namespace {

/// The samples whose names begin with `prefix`, in order, without "rigsound_".
std::vector<std::string> samples(const Snapshot& snapshot, const std::string& prefix = "") {
  const std::string text = to_openmetrics(snapshot), begin = "rigsound_" + prefix;
  std::vector<std::string> found;
  std::size_t start = 0;
  for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    if (text.compare(start, begin.size(), begin) == 0)
      found.push_back(text.substr(start + 9, end - start - 9));
  return found;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("Every figure of the card, the blocks, the output and the exposure has its own series") {
  const Lines all = samples(telling_snapshot());
  const Lines begin(all.begin(), all.begin() + 26);
  CHECK(begin == Lines{"blocks_total 1000",
                       "xruns_total 11",
                       "suspends_total 12",
                       "bad_states_total 13",
                       "short_writes_total 14",
                       "interruptions_total 15",
                       "card_losses_total 16",
                       "deadline_misses_total 21",
                       "clock_jumps_total 25",
                       "skipped_blocks_total 26",
                       "card_playing 1",
                       "block_time_mean_seconds 0.0005",
                       "block_time_worst_seconds 0.001",
                       "limiter_gain_since_scrape_ratio 0.75",
                       "peak_since_scrape_ratio 0.5",
                       "rms_since_scrape_ratio 0.25",
                       "lost_clicks_total 23",
                       "dropped_chunks_total 24",
                       "output_gain_ratio 0.875",
                       "sound_level_fast_decibels 71",
                       "sound_level_slow_decibels 72",
                       "sound_level_minute_decibels 73",
                       "exposure_8h_decibels 74",
                       "exposure_peak_decibels 75",
                       "exposure_turned_down_decibels 77",
                       "layer_peak_since_scrape_ratio{layer=\"diesel\"} 0.125"});
  const Lines end(all.end() - 4, all.end());
  CHECK(end == Lines{"lost_log_entries_total 33", "lost_session_records_total 22", "reloads_total 31",
                     "failed_reloads_total 32"});
  Snapshot silent = telling_snapshot();
  silent.card.playing = false;
  CHECK(samples(silent, "card_playing") == Lines{"card_playing 0"});
}

TEST_CASE("Levels of layers: the diesel, each boom's drill, and its tool or string where it has one") {
  Snapshot s = telling_snapshot();
  CHECK(samples(s, "layer_peak") ==
        Lines{"layer_peak_since_scrape_ratio{layer=\"diesel\"} 0.125",
              "layer_peak_since_scrape_ratio{boom=\"left\",layer=\"drill\"} 0.03125",
              "layer_peak_since_scrape_ratio{boom=\"left\",layer=\"string\"} 0.0078125"});
  CHECK(samples(s, "layer_rms") ==
        Lines{"layer_rms_since_scrape_ratio{layer=\"diesel\"} 0.0625",
              "layer_rms_since_scrape_ratio{boom=\"left\",layer=\"drill\"} 0.015625",
              "layer_rms_since_scrape_ratio{boom=\"left\",layer=\"string\"} 0.00390625"});
  s.booms[0].tool.clear();
  CHECK(samples(s, "layer_rms").size() == 2);
}

TEST_CASE("A boom is in one situation of the five; what it asks for, makes and plays is told") {
  Snapshot s = telling_snapshot();
  CHECK(samples(s, "boom_") ==
        Lines{"boom_situation{boom=\"left\",rigsound_boom_situation=\"normal\"} 0",
              "boom_situation{boom=\"left\",rigsound_boom_situation=\"underfeed\"} 0",
              "boom_situation{boom=\"left\",rigsound_boom_situation=\"overfeed\"} 0",
              "boom_situation{boom=\"left\",rigsound_boom_situation=\"closed_rattling\"} 0",
              "boom_situation{boom=\"left\",rigsound_boom_situation=\"open_rattling\"} 1",
              "boom_feed_deviation{boom=\"left\"} -1.5", "boom_hammering{boom=\"left\"} 1",
              "boom_impacts_wanted_hertz{boom=\"left\"} 40", "boom_impacts_made_hertz{boom=\"left\"} 39",
              "boom_bank_share_ratio{boom=\"left\",bank=\"hard\",rods=\"6\",rock=\"granite\"} 0.75",
              "boom_bank_share_ratio{boom=\"left\",bank=\"soft\",rods=\"any\",rock=\"any\"} 0.25"});
  s.booms[0].hammering = false;
  CHECK(samples(s, "boom_hammering") == Lines{"boom_hammering{boom=\"left\"} 0"});
}

TEST_CASE("Each bus is up or not and has its counters, and no other's") {
  CHECK(samples(telling_snapshot(), "bus_") ==
        Lines{"bus_up{bus=\"can can0\"} 1", "bus_up{bus=\"udp :9\"} 0",
              "bus_frames_seen_total{bus=\"can can0\"} 51", "bus_frames_seen_total{bus=\"udp :9\"} 53",
              "bus_frames_bad_total{bus=\"can can0\"} 52", "bus_losses_total{bus=\"udp :9\"} 54"});
}

TEST_CASE("A signal has an age from 0 s on, a value once it was said, and one state") {
  const Lines told = samples(telling_snapshot(), "signal_");
  const Lines begin(told.begin(), told.begin() + 9);
  CHECK(begin ==
        Lines{"signal_age_seconds{signal=\"engine_rpm\"} 0",
              "signal_value{signal=\"engine_rpm\",unit=\"r/min\"} 1500",
              "signal_value{signal=\"rock\",unit=\"\"} 1", "signal_refused_total{signal=\"engine_rpm\"} 41",
              "signal_refused_total{signal=\"rock\"} 43", "signal_refused_total{signal=\"rod_count\"} 0",
              "signal_clamped_total{signal=\"engine_rpm\"} 42", "signal_clamped_total{signal=\"rock\"} 44",
              "signal_clamped_total{signal=\"rod_count\"} 0"});
  Lines states;
  for (const char* state :
       {"never_seen", "valid", "stale", "bus_down", "error_value", "not_available", "out_of_range", "manual"})
    states.push_back(std::string("signal_state{signal=\"rock\",rigsound_signal_state=\"") + state + "\"} " +
                     (std::string(state) == "manual" ? "1" : "0"));
  CHECK(samples(telling_snapshot(), "signal_state{signal=\"rock\"") == states);
}

TEST_CASE("Names with quotes, backslashes and line breaks are escaped as OpenMetrics wants it") {
  Snapshot s = telling_snapshot();
  s.buses = {{"a\\b\"c\nd", true, "", {}}};
  CHECK(samples(s, "bus_up") == Lines{R"(bus_up{bus="a\\b\"c\nd"} 1)"});
}

TEST_CASE("A unit is announced for the families that have one, and for no other") {
  const std::string text = to_openmetrics(telling_snapshot());
  CHECK(text.find("# TYPE rigsound_block_time_mean_seconds gauge\n# UNIT rigsound_block_time_mean_seconds "
                  "seconds\n# HELP rigsound_block_time_mean_seconds Time") != std::string::npos);
  CHECK(text.find("# TYPE rigsound_blocks counter\n# HELP rigsound_blocks Blocks rendered.\n"
                  "rigsound_blocks_total 1000\n") != std::string::npos);
}
