// One reader a section of the rig file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "rigsound/config/rig.hpp"
#include "toml/toml_table.hpp"

namespace rigsound::config {

audio::AudioOptions read_audio(TomlTable table);
SceneOptions read_scene(TomlTable table);
struct MixSection {
  MixOptions mix;
  CalibrationOptions calibration;  ///< what the sound does not follow
};
MixSection read_mix(TomlTable table);
ControlOptions read_control(TomlTable table, const std::filesystem::path& folder);

/// [sound]
struct SoundSection {
  std::string set;        ///< folder of the sound set; empty: none
  std::int64_t seed = 1;  ///< of the engine
};

template <class Archive>
void fields(Archive& a, SoundSection& o) {
  a("set", o.set);
  a("seed", o.seed, Range{0, 2147483647});
}

SoundSection read_sound(TomlTable table);

struct Booms {
  std::vector<BoomOptions> options;
  std::vector<std::string> tools;
  std::vector<int> tool_lines;
};
Booms read_booms(std::vector<TomlTable> tables);

/// What buses promise about each signal: the age at which it is stale unless the rig says otherwise.
/// 0 where nothing is promised.
using StaleDefaults = std::array<double, kSignalCount>;
SafetyOptions read_safety(TomlTable table, const StaleDefaults& stale);

/// A bus, and what is probably a mistake in its section: one line each.
struct CanBusRead {
  can::CanOptions options;
  std::vector<std::filesystem::path> dbc_files;
  std::vector<std::string> doubts;
};
CanBusRead read_can(TomlTable table, const std::filesystem::path& folder,
                    const std::vector<BoomOptions>& booms);

struct ModbusRead {
  modbus::ModbusOptions options;
  std::vector<std::string> doubts;
};
ModbusRead read_modbus(TomlTable table, const std::vector<BoomOptions>& booms);

/// `free_signals`: what no other bus of the rig delivers; a table that names none takes them all.
udp::UdpOptions read_udp(TomlTable table, const std::vector<udp::NameRoute>& free_signals);

/// [osc]: off where the table is absent.
osc::OscOptions read_osc(TomlTable table, const std::vector<udp::NameRoute>& free_signals,
                         const std::vector<BoomOptions>& booms);

/// Walks a table `signal = ...`, in which a boom's name holds a table of that boom's signals. Calls `each`
/// with the table that holds the key, the key and the signal. Refuses names that are no signal.
void read_signals(TomlTable table, const std::vector<BoomOptions>& booms,
                  const std::function<void(TomlTable&, const std::string& key, SignalId)>& each);

}  // namespace rigsound::config
