// Everything the daemon can tell about itself at one moment: `ctl status`, `ctl watch`, metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/audio/sound_card.hpp"
#include "rigsound/bus/bus.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::daemon {

struct SignalSnapshot {
  std::string name, unit;
  double value = 0;      ///< after the safety rule
  double age_s = -1;     ///< since it was last good; negative: never
  std::string validity;  ///< "manual" while a user holds it
  std::string word;      ///< of the value, or the rock's name; empty: it is a number
  std::uint64_t refused = 0, clamped = 0;
  std::optional<double> last_refused;  ///< what was last refused, when it was a number
};

struct BusSnapshot {
  std::string name;  ///< "can can0", "modbus 127.0.0.1:1502"
  bool up = false;
  std::string problem;  ///< empty while all is well
  std::vector<BusCounter> counters;
};

/// Linear, full scale 1.
struct LevelSnapshot {
  double peak = 0, rms = 0;
};

struct BankSnapshot {
  std::string name;
  double share = 0;
  int rods = 0;      ///< it was recorded with; 0: any
  std::string rock;  ///< it was recorded in; empty: any
};

/// Why a boom sounds as it does.
struct BoomSnapshot {
  std::string name;
  DrillControls controls;
  Situation situation = Situation::kUnderfeed;
  bool hammering = false;
  double feed_deviation = 0;
  std::vector<BankSnapshot> banks;  ///< falling in share
  int rods = 1;
  std::string rock;  ///< asked for: its name, or its number when the sound set has none of it
  double impacts_wanted_hz = 0, impacts_made_hz = 0;
  std::string tool;  ///< "tool", "string", or empty: none that rings
  LevelSnapshot drill_level, tool_level;
};

/// At the ear, by the rig's calibration; 0 dB: silence, or less.
struct ExposureSnapshot {
  double fast_db = 0, slow_db = 0;  ///< A-weighted level now, dB(A)
  double minute_db = 0;             ///< A-weighted equivalent level of about the last minute, dB(A)
  double day_db = 0;                ///< L_EX,8h: what was heard since the reset, spread over 8 h, dB(A)
  double peak_db = 0;               ///< L_C,peak since the reset, dB(C)
  double since_s = 0;               ///< sound since the reset
  double turned_down_db = 0;        ///< by which the limit has turned the output down
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
  std::uint64_t blocks = 0, deadline_misses = 0, lost_records = 0;
  std::uint64_t lost_clicks = 0, dropped_chunks = 0;  ///< of the run, as in EngineMeters
  std::uint64_t clock_jumps = 0, skipped_blocks = 0;
  double block_s = 0;       ///< length of a block
  double block_mean_s = 0;  ///< time to compute one
  double block_worst_s = 0;
  LevelSnapshot output,
      diesel;               ///< these and the booms': of the last moments; of a scrape: since the last one
  double limiter_gain = 1;  ///< lowest of that time, linear
  double output_gain = 1;   ///< linear
  std::optional<ExposureSnapshot> exposure;  ///< none without a calibration
  bool muted = false, paused = false;
  bool no_buses = false;  ///< started with --manual
  std::uint64_t reloads = 0, failed_reloads = 0, lost_log_entries = 0;
  std::vector<SignalSnapshot> signals;
  std::vector<BusSnapshot> buses;
  std::vector<BoomSnapshot> booms;
  SessionSnapshot session;
};

std::string to_openmetrics(const Snapshot& snapshot);  ///< ends with `# EOF`

}  // namespace rigsound::daemon
