// Everything the daemon can tell about itself at one moment: `ctl status`, `ctl watch`, metrics.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/audio/sound_card.hpp"
#include "rigsound/bus/bus.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound::daemon {

struct SignalSnapshot {
  std::string name, unit;
  double value = 0;   ///< after the safety rule
  double age_s = -1;  ///< since it was last good; negative: never
  std::string validity;
};

struct BusSnapshot {
  std::string name;  ///< "can can0", "modbus 127.0.0.1:1502"
  bool up = false;
  std::string problem;  ///< empty while all is well
  std::vector<BusCounter> counters;
};

struct BoomSnapshot {
  std::string name;
  DrillControls controls;
};

struct SessionSnapshot {
  std::string file, problem;
  bool recording = false;
  std::uint64_t bytes = 0;
};

struct Snapshot {
  std::string version, rig;
  double uptime_s = 0;
  audio::CardStatus card;
  std::string scheduling;
  std::uint64_t blocks = 0, deadline_misses = 0, lost_clicks = 0, lost_records = 0;
  double block_s = 0;       ///< length of a block
  double block_mean_s = 0;  ///< time to compute one
  double block_worst_s = 0;
  double peak = 0, rms = 0, limiter_gain = 1, output_gain = 1;  ///< linear
  bool muted = false;
  std::uint64_t reloads = 0, failed_reloads = 0, lost_log_entries = 0;
  std::vector<SignalSnapshot> signals;
  std::vector<BusSnapshot> buses;
  std::vector<BoomSnapshot> booms;
  SessionSnapshot session;
};

std::string to_json(const Snapshot& snapshot);         ///< one line, no newline
std::string to_openmetrics(const Snapshot& snapshot);  ///< ends with `# EOF`

}  // namespace rigsound::daemon
