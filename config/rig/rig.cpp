#include "rigsound/config/rig.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "rig/sections.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/modbus/exchange.hpp"
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

/// A server cannot know how often its clients write, nor who turns a knob over OSC: they promise nothing.
StaleDefaults stale_defaults(const Rig& rig) {
  StaleDefaults stale{};
  for (const can::CanOptions& bus : rig.can)
    for (const can::SignalRoute& route : bus.routes) note_stale(stale, route.target.signal, route.cycle_s);
  for (const modbus::ModbusOptions& link : rig.modbus)
    for (const modbus::RegisterRoute& route : link.routes)
      if (link.role == modbus::Role::kClient) note_stale(stale, route.target.signal, link.poll_s);
  for (const udp::UdpOptions& input : rig.udp)
    for (const udp::NameRoute& route : input.routes) note_stale(stale, route.target.signal, 0);
  return stale;
}

void require_one_source(const Rig& rig, const TomlTable& root) {
  std::set<std::pair<Signal, int>> seen;
  for (const SignalSource& source : sources_of(rig))
    if (!seen.emplace(source.signal.signal, source.signal.boom).second)
      root.fail(source.section, "delivers " + signal_label(rig, source.signal) +
                                    ", but another bus does too, expected one source");
}

void require_own_interfaces(const Rig& rig, const TomlTable& root) {
  std::set<std::string> seen;
  for (const can::CanOptions& bus : rig.can)
    if (!seen.insert(bus.interface).second)
      root.fail(
          "can",
          "names the interface " + bus.interface +
              " twice, expected one [[can]] for each, with dbc = [\"a.dbc\", \"b.dbc\"] for several files");
}

std::string canonical(const std::string& device) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::weakly_canonical(device, error);
  return error ? device : path.string();
}

bool any_address(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

/// Whether both would be at the same time on one serial line, or listen at one port.
bool share_a_line(const modbus::ModbusOptions& a, const modbus::ModbusOptions& b) {
  using modbus::Role;
  using modbus::Transport;
  if ((a.transport == Transport::kRtu) != (b.transport == Transport::kRtu)) return false;
  if (a.transport == Transport::kRtu) return canonical(a.address) == canonical(b.address);
  if (a.role != b.role) return false;
  const bool same_host =
      a.host == b.host || (a.role == Role::kServer && (any_address(a.host) || any_address(b.host)));
  return a.port == b.port && same_host;
}

std::string line_conflict(const modbus::ModbusOptions& a, const modbus::ModbusOptions& b) {
  if (a.role == modbus::Role::kServer || b.role == modbus::Role::kServer)
    return a.transport == modbus::Transport::kRtu
               ? "is on a line with a server, expected one server or masters on it"
               : "is a port that two servers listen at, expected one [[modbus]] for each, with unit = 255 "
                 "for any";
  if (a.address != b.address)
    return "is the same line as " + a.address + ", expected the same address for both";
  if (a.transport != b.transport || a.baud != b.baud || a.parity != b.parity || a.stop_bits != b.stop_bits ||
      a.timeout_s != b.timeout_s || a.pause_s != b.pause_s)
    return "is a line that another [[modbus]] shares, expected the same transport, baud, parity, stop_bits, "
           "timeout_ms and pause_ms for both";
  return {};
}

void require_own_lines(const Rig& rig, const TomlTable& root) {
  for (std::size_t i = 0; i < rig.modbus.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (!share_a_line(rig.modbus[k], rig.modbus[i])) continue;
      const std::string conflict = line_conflict(rig.modbus[k], rig.modbus[i]);
      if (!conflict.empty()) root.fail("modbus", rig.modbus[i].address + " " + conflict);
    }
}

/// A unit's signals are down when the last of them is stale, and not while a device pauses.
void set_down_ages(Rig& rig) {
  constexpr double kLeast_s = 0.3, kPolls = 3;
  for (modbus::ModbusOptions& link : rig.modbus) {
    link.down_after_s = std::max({kLeast_s, kPolls * link.poll_s, link.timeout_s});
    for (const modbus::RegisterRoute& route : link.routes)
      link.down_after_s = std::max(
          link.down_after_s, rig.safety.rule[static_cast<std::size_t>(route.target.signal)].stale_after_s);
  }
}

void take_sound(const TomlTable& table, const std::filesystem::path& folder, Rig& rig) {
  const SoundSection sound = read_sound(table);
  rig.sound_set_line = table.line_of("set");
  if (!sound.set.empty()) rig.sound_set = (folder / sound.set).lexically_normal();
  rig.engine.seed = static_cast<std::uint64_t>(sound.seed);
}

/// Signals that no bus read so far delivers.
std::vector<udp::NameRoute> free_signals(const Rig& rig) {
  std::set<std::pair<Signal, int>> taken;
  for (const SignalSource& source : sources_of(rig)) taken.emplace(source.signal.signal, source.signal.boom);
  std::vector<udp::NameRoute> routes;
  for_each_signal(static_cast<int>(rig.engine.booms.size()), [&](SignalId id) {
    if (taken.count({id.signal, id.boom}) != 0) return;
    const std::string name = signal_label(rig, id);
    const bool of_first_boom = info(id.signal).per_boom && id.boom == 0;
    routes.push_back({id, name, of_first_boom ? rig.engine.booms.front().name + "." + name : ""});
  });
  return routes;
}

template <class Read, class Options>
void take_bus(Read read, std::vector<Options>& buses, std::vector<std::string>& doubts) {
  buses.push_back(std::move(read.options));
  doubts.insert(doubts.end(), read.doubts.begin(), read.doubts.end());
}

void read_buses(TomlTable& root, const std::filesystem::path& folder, Rig& rig) {
  for (TomlTable& table : root.tables("can")) {
    CanBusRead read = read_can(table, folder, rig.engine.booms);
    rig.dbc_files.insert(rig.dbc_files.end(), read.dbc_files.begin(), read.dbc_files.end());
    take_bus(std::move(read), rig.can, rig.doubts);
  }
  for (TomlTable& table : root.tables("modbus"))
    take_bus(read_modbus(table, rig.engine.booms), rig.modbus, rig.doubts);
  for (TomlTable& table : root.tables("udp")) {
    rig.udp.push_back(read_udp(table, free_signals(rig)));
    if (rig.udp.back().routes.empty())
      table.fail("signals", "there is none left that no other bus delivers, expected one or more");
  }
  rig.osc = read_osc(root.table("osc"), free_signals(rig), rig.engine.booms);
}

/// Without a calibration nobody knows how loud it is.
void require_calibrated(const Rig& rig, const TomlTable& root) {
  if (rig.safety.max_laeq_db > 0 && rig.calibration.db_spl_at_0dbfs == 0)
    root.fail(InvalidField("", "safety.max_laeq_db",
                           "is " + number_text(rig.safety.max_laeq_db) +
                               " dB of an output that is not calibrated, expected mix.db_spl_at_0dbfs too"));
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
  return parse_rig(read_text(file, kRigText), file, buses);
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
  MixSection mix = read_mix(root.table("mix"));
  rig.engine.mix = std::move(mix.mix);
  rig.calibration = mix.calibration;
  require_playable(rig, root);
  if (buses == Buses::kRead)
    read_buses(root, folder, rig);
  else
    for (const char* section : {"can", "modbus", "udp", "osc"}) root.expect(section);
  rig.safety = read_safety(root.table("safety"), stale_defaults(rig));
  require_calibrated(rig, root);
  set_down_ages(rig);
  rig.safety.idle_rpm = rig.engine.scene.idle_rpm;
  rig.control = read_control(root.table("control"), folder);
  root.refuse_unknown();
  require_own_interfaces(rig, root);
  require_own_lines(rig, root);
  require_one_source(rig, root);
  return rig;
}

std::vector<std::filesystem::path> files_of(const Rig& rig) {
  std::vector<std::filesystem::path> files = content_of(rig.sound_set);
  files.push_back(rig.file);
  files.insert(files.end(), rig.dbc_files.begin(), rig.dbc_files.end());
  return files;
}

std::vector<SignalSource> sources_of(const Rig& rig) {
  std::vector<SignalSource> sources;
  for (const can::CanOptions& bus : rig.can)
    for (const can::SignalRoute& route : bus.routes)
      sources.push_back({route.target, "can", bus.interface, route.name});
  for (const modbus::ModbusOptions& link : rig.modbus)
    for (const modbus::RegisterRoute& route : link.routes)
      sources.push_back({route.target, "modbus", link.address, modbus::describe(route.table, route.address)});
  for (const udp::UdpOptions& input : rig.udp)
    for (const udp::NameRoute& route : input.routes)
      sources.push_back({route.target, "udp", input.address, route.name});
  for (const udp::NameRoute& route : rig.osc.routes)
    sources.push_back({route.target, "osc", rig.osc.address, route.name});
  return sources;
}

log::Buses buses_of(const Rig& rig) { return {rig.can, rig.modbus, rig.udp}; }

std::string signal_label(const Rig& rig, SignalId id) {
  std::string name(info(id.signal).name);
  if (id.boom == 0 || id.boom >= rig.engine.booms.size()) return name;
  return rig.engine.booms[id.boom].name + "." + name;
}

}  // namespace rigsound::config
