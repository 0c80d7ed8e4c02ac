#include "rigsound/config/rig.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "rig/sections.hpp"
#include "rigsound/machine/input_error.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {
namespace {

constexpr double kCyclesUntilStale = 3, kLeastStale = 0.1;  // s
constexpr double kStaleWithoutCycle = 1.0;                  // s

void note_stale(StaleDefaults& stale, Signal s, double cycle_s) {
  const double after = cycle_s > 0 ? std::max(kLeastStale, kCyclesUntilStale * cycle_s) : kStaleWithoutCycle;
  double& limit = stale[static_cast<std::size_t>(s)];
  limit = std::max(limit, after);
}

/// A server cannot know how often its clients write, so it promises nothing.
StaleDefaults stale_defaults(const Rig& rig) {
  StaleDefaults stale{};
  for (const can::CanOptions& bus : rig.can)
    for (const can::SignalRoute& route : bus.routes) note_stale(stale, route.target.signal, route.cycle_s);
  for (const modbus::ModbusOptions& link : rig.modbus)
    for (const modbus::RegisterRoute& route : link.routes)
      if (link.role == modbus::Role::kClient) note_stale(stale, route.target.signal, link.poll_s);
  return stale;
}

void require_one_source(const Rig& rig, const TomlTable& root) {
  std::set<std::pair<Signal, int>> seen;
  const auto note = [&](const char* section, SignalId id) {
    if (!seen.emplace(id.signal, id.boom).second)
      root.fail(section,
                "delivers " + signal_label(rig, id) + ", but another bus does too, expected one source");
  };
  for (const can::CanOptions& bus : rig.can)
    for (const can::SignalRoute& route : bus.routes) note("can", route.target);
  for (const modbus::ModbusOptions& link : rig.modbus)
    for (const modbus::RegisterRoute& route : link.routes) note("modbus", route.target);
}

void require_own_interfaces(const Rig& rig, const TomlTable& root) {
  std::set<std::string> seen;
  for (const can::CanOptions& bus : rig.can)
    if (!seen.insert(bus.interface).second)
      root.fail("can", "names the interface " + bus.interface + " twice, expected one [[can]] for each");
}

void take_sound(const TomlTable& table, const std::filesystem::path& folder, Rig& rig) {
  const SoundSection sound = read_sound(table);
  rig.sound_set_line = table.line_of("set");
  if (!sound.set.empty()) rig.sound_set = (folder / sound.set).lexically_normal();
  rig.engine.seed = static_cast<std::uint64_t>(sound.seed);
}

/// What the engine would refuse is refused where the file says it.
void require_playable(const Rig& rig, const TomlTable& root) {
  try {
    require_valid(rig.engine);
  } catch (const InvalidField& error) {
    root.fail(error);
  }
}

}  // namespace

Rig load_rig(const std::filesystem::path& file, Buses buses) {
  return parse_rig(read_text(file), file, buses);
}

Rig parse_rig(std::string_view text, const std::filesystem::path& file, Buses buses) {
  TomlTable root = TomlTable::parse(text, file.string());
  const std::filesystem::path folder = file.parent_path();
  Rig rig;
  rig.file = file;
  rig.audio = read_audio(root.table("audio"));
  take_sound(root.table("sound"), folder, rig);
  Booms booms = read_booms(root.tables("boom"));
  rig.boom_tools = std::move(booms.tools);
  rig.boom_tool_lines = std::move(booms.tool_lines);
  rig.engine.sample_rate = rig.audio.rate;
  rig.engine.block = rig.audio.block;
  rig.engine.channels = rig.audio.channels;
  rig.engine.booms = std::move(booms.options);
  rig.engine.scene = read_scene(root.table("scene"));
  rig.engine.mix = read_mix(root.table("mix"));
  require_playable(rig, root);
  std::vector<TomlTable> can = root.tables("can"), modbus = root.tables("modbus");
  if (buses == Buses::kLeftOut) can.clear(), modbus.clear();
  for (TomlTable& table : can) rig.can.push_back(read_can(table, folder, rig.engine.booms));
  for (TomlTable& table : modbus) rig.modbus.push_back(read_modbus(table, rig.engine.booms));
  rig.safety = read_safety(root.table("safety"), stale_defaults(rig));
  rig.safety.idle_rpm = rig.engine.scene.idle_rpm;
  rig.control = read_control(root.table("control"));
  root.refuse_unknown();
  require_own_interfaces(rig, root);
  require_one_source(rig, root);
  return rig;
}

std::string signal_label(const Rig& rig, SignalId id) {
  std::string name(info(id.signal).name);
  if (id.boom == 0 || id.boom >= rig.engine.booms.size()) return name;
  return rig.engine.booms[id.boom].name + "." + name;
}

}  // namespace rigsound::config
