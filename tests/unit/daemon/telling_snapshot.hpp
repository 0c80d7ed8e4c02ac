// A snapshot in which every figure is another one, so that none can stand for its neighbour.
#pragma once

#include "snapshot.hpp"

namespace rigsound::test {

inline daemon::Snapshot telling_snapshot() {
  daemon::Snapshot s;
  s.version = "1.2.3";
  s.rig = "rig.toml";
  s.uptime_s = 90;
  s.card = {true, "hw:0", audio::SampleFormat::kFloat, {11, 12, 13, 14, 15, 16}};
  s.scheduling = "SCHED_FIFO 70";
  s.blocks = 1000;
  s.deadline_misses = 21;
  s.lost_records = 22;
  s.lost_clicks = 23;
  s.dropped_chunks = 24;
  s.clock_jumps = 25;
  s.skipped_blocks = 26;
  s.block_s = 0.002;
  s.block_mean_s = 0.0005;
  s.block_worst_s = 0.001;
  s.output = {0.5, 0.25};
  s.diesel = {0.125, 0.0625};
  s.limiter_gain = 0.75;
  s.output_gain = 0.875;
  s.exposure = daemon::ExposureSnapshot{71, 72, 73, 74, 75, 76, 77};
  s.muted = true;
  s.reloads = 31;
  s.failed_reloads = 32;
  s.lost_log_entries = 33;
  s.signals = {{"engine_rpm", "r/min", 1500, 0, "valid", "", 41, 42, {}},
               {"rock", "", 1, -1, "manual", "marble", 43, 44, 910},
               {"rod_count", "", 5, -1, "never_seen", "", 0, 0, {}}};
  s.buses = {{"can can0", true, "", {{"frames_seen", 51}, {"frames_bad", 52}}},
             {"udp :9", false, "no route", {{"frames_seen", 53}, {"losses", 54}}}};
  s.booms.resize(1);
  daemon::BoomSnapshot& boom = s.booms[0];
  boom.name = "left";
  boom.situation = Situation::kOpenRattling;
  boom.hammering = true;
  boom.feed_deviation = -1.5;
  boom.banks = {{"hard", 0.75, 6, "granite"}, {"soft", 0.25, 0, ""}};
  boom.rods = 3;
  boom.rock = "slate";
  boom.impacts_wanted_hz = 40;
  boom.impacts_made_hz = 39;
  boom.tool = "string";
  boom.drill_level = {0.03125, 0.015625};
  boom.tool_level = {0.0078125, 0.00390625};
  s.session = {"run.rigs", "disk full", true, 4096};
  return s;
}

}  // namespace rigsound::test
