// One rig file: everything the daemon, `render`, `decode` and `check` are told at start-up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/can/can_options.hpp"
#include "rigsound/config/sounding_rig.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/modbus/modbus_options.hpp"
#include "rigsound/osc/osc_options.hpp"
#include "rigsound/sound_level_meter.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::config {

struct ControlOptions {
  std::string socket = "/run/rigsound/control.sock";  ///< path of the control socket; empty: none
  int socket_line = 0;                                ///< of the rig file, for messages
  std::string group;                                  ///< the socket's; empty: the daemon's own
  int group_line = 0;                                 ///< of the rig file, for messages
  std::string mode = "0660";                          ///< the socket's, octal
  unsigned mode_bits = 0660;                          ///< taken from `mode`
  std::string tcp;                                    ///< the same on a loopback HOST:PORT; empty: off
  std::string token_file;                             ///< of the token that a client on `tcp` must say first
  std::string metrics;                                ///< HOST:PORT for OpenMetrics; empty: off
};

template <class Archive>
void fields(Archive& a, ControlOptions& o) {
  a("socket", o.socket);
  a("group", o.group);
  a("mode", o.mode);
  a("tcp", o.tcp);
  a("token_file", o.token_file);
  a("metrics", o.metrics);
}

/// Every option checked, every path absolute or relative to the working directory.
struct Rig : SoundingRig {
  audio::AudioOptions audio;
  SafetyOptions safety;
  CalibrationOptions calibration;  ///< [mix] db_spl_at_0dbfs
  std::vector<can::CanOptions> can;
  std::vector<std::filesystem::path> dbc_files;  ///< that they were read from
  std::vector<modbus::ModbusOptions> modbus;
  std::vector<udp::UdpOptions> udp;
  osc::OscOptions osc;
  ControlOptions control;
  std::vector<std::string>
      doubts;  ///< what is probably a mistake, `FILE:LINE: KEY: what is odd, what was meant?`
};

/// Whether a rig's buses, and the files they name, are wanted at all.
enum class Buses : std::uint8_t { kRead, kLeftOut };

/// Reads and checks a rig file and the DBC files it names. Only keys of a bus without a sensible default
/// are required ([[can]] interface and dbc); everything else has the default that config/rigs/demo.toml
/// shows. Paths in the file are relative to its folder. Errors: InputError. Thread: OFF.
Rig load_rig(const std::filesystem::path& file, Buses buses = Buses::kRead);

/// The same from text; `file` is for messages and for paths relative to its folder.
Rig parse_rig(std::string_view text, const std::filesystem::path& file, Buses buses = Buses::kRead);

/// Reads the rig's sound set at the rig's rate and finds the tool of each boom in it. A set without a
/// background gets the built-in diesel: a rig whose engine runs is never silent.
/// Errors: InputError, also when the rig names no sound set. Thread: OFF.
SoundSet load_sounds(Rig& rig);

/// What `[control] token_file` holds; empty without one. Errors: InputError when it is no token, or anybody
/// may read it. Thread: OFF.
std::string control_token(const Rig& rig);

/// What the rig was and will be read from: its file, its sound set, its DBC files.
std::vector<std::filesystem::path> files_of(const Rig& rig);

/// Where a signal comes from.
struct SignalSource {
  SignalId signal{};
  std::string section;  ///< of the rig file: can, modbus, udp, osc
  std::string address;  ///< the bus's: can0, 192.168.1.5:502
  std::string from;     ///< the signal, register or name on the bus
};

/// Of every signal that a bus delivers, in the order of the rig file's buses.
std::vector<SignalSource> sources_of(const Rig& rig);

/// The buses of the rig, for reading a log of them.
log::Buses buses_of(const Rig& rig);

/// "engine_rpm", "feed_pressure_bar" of the first boom, "NAME.feed_pressure_bar" of another.
std::string signal_label(const Rig& rig, SignalId id);

}  // namespace rigsound::config
