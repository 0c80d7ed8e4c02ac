#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "check/check_json.hpp"
#include "check/modbus_probe.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/rig_paths.hpp"
#include "rigsound/feed_reach.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

void print_rule(const config::Rig& rig, SignalId id) {
  const SafetyRule& rule = rig.safety.rule[static_cast<std::size_t>(id.signal)];
  if (rule.stale_after_s > 0)
    fmt::print("  stale after {:g} ms: {}\n", rule.stale_after_s * 1000,
               kStaleActions[static_cast<std::size_t>(rule.action)]);
  else
    fmt::print("  never stale\n");
}

void print_can(const config::Rig& rig) {
  for (const can::CanOptions& bus : rig.can) {
    fmt::print("can {}{}: {} signals\n", bus.interface, bus.fd ? " (fd)" : "", bus.routes.size());
    for (const can::SignalRoute& route : bus.routes) {
      fmt::print("  {:<20} {} ({} {:X})", config::signal_label(rig, route.target), route.name,
                 route.match.j1939 ? "J1939 like" : "id", route.match.id);
      print_rule(rig, route.target);
    }
  }
}

void print_modbus(const config::Rig& rig) {
  for (const modbus::ModbusOptions& link : rig.modbus) {
    fmt::print("modbus {} {}: {} signals\n", link.role == modbus::Role::kServer ? "server" : "client",
               link.address, link.routes.size());
    for (const modbus::RegisterRoute& route : link.routes) {
      fmt::print("  {:<20} {}", config::signal_label(rig, route.target),
                 modbus::describe(route.table, route.address));
      print_rule(rig, route.target);
    }
  }
}

void print_udp(const config::Rig& rig) {
  for (const udp::UdpOptions& input : rig.udp) {
    fmt::print("udp {}: {} signals\n", input.address, input.routes.size());
    for (const udp::NameRoute& route : input.routes) {
      fmt::print("  {:<20}", route.name);
      print_rule(rig, route.target);
    }
  }
}

void print_osc(const config::Rig& rig) {
  const osc::OscOptions& osc = rig.osc;
  if (!osc.address.empty())
    fmt::print("osc {}: {} signals, controls, mute\n", osc.address, osc.routes.size());
  for (const std::string& target : osc.targets)
    fmt::print("osc to {} every {:g} ms\n", target, osc.every_s * 1e3);
}

std::vector<std::string> missing_signals(const config::Rig& rig) {
  const std::vector<config::SignalSource> sources = config::sources_of(rig);
  std::vector<std::string> missing;
  for (const Signal needed : {Signal::kEngineRpm, Signal::kFeedPressureBar, Signal::kRattling})
    if (std::none_of(sources.begin(), sources.end(),
                     [&](const config::SignalSource& source) { return source.signal.signal == needed; }))
      missing.push_back(fmt::format("{}: no bus delivers {}, it will stay at {:g}", rig.file.string(),
                                    info(needed).name, info(needed).absent));
  return missing;
}

/// "level from 262 bar, decay from 240 bar", of one end.
std::string limits_text(const scene::FeedReach& reach, const std::function<bool(double)>& beyond) {
  std::string text;
  for (const scene::TrendLimit& limit : reach.limits)
    if (beyond(limit.feed_bar))
      text += fmt::format("{}{} from {:.0f} bar", text.empty() ? "" : ", ", limit.parameter, limit.feed_bar);
  return text.empty() ? "nothing" : text;
}

/// Where the trends beyond the recorded feeds flatten.
void print_feed_reach(const CheckedRig& checked) {
  for (const scene::FeedReach& reach : checked.reach)
    fmt::print("feed, {} {}{}: {} banks at {:g} to {:g} bar; flattens below them: {}; above: {}\n",
               reach.rods, reach.rods == 1 ? "rod" : "rods",
               reach.rock < 0 ? "" : ", " + checked.rocks[static_cast<std::size_t>(reach.rock)], reach.banks,
               reach.lowest_bar, reach.highest_bar,
               limits_text(reach, [&](double bar) { return bar <= reach.lowest_bar; }),
               limits_text(reach, [&](double bar) { return bar >= reach.highest_bar; }));
}

CheckedRig checked_rig(const config::Rig& rig, const SoundSet& sounds) {
  CheckedRig checked{rig, {}, {}, scene::feed_reach(sounds, rig.engine.scene), missing_signals(rig)};
  checked.sounds = {sounds.banks.size(), 0, sounds.rocks.size(), sounds.tools.size() + sounds.strings.size(),
                    sounds.diesels.front().name};
  for (const ClickBank& bank : sounds.banks) checked.sounds.clicks += bank.clicks.size();
  for (const auto& rock : sounds.rocks) checked.rocks.push_back(rock.name);
  return checked;
}

void print_text(const CheckedRig& checked) {
  const config::Rig& rig = checked.rig;
  const SoundCounts& sounds = checked.sounds;
  fmt::print("ok\n");
  fmt::print("audio {}: {:g} Hz, {} channels, blocks of {} frames ({:.2f} ms), {} periods\n",
             rig.audio.device, rig.audio.rate, rig.audio.channels, rig.audio.block,
             rig.audio.block / rig.audio.rate * 1000, rig.audio.periods);
  fmt::print("sound set {}: {} banks, {} clicks, {} rocks, {} tools, background: {}\n",
             rig.sound_set.string(), sounds.banks, sounds.clicks, sounds.rocks, sounds.tools,
             sounds.background);
  fmt::print("booms:");
  for (const BoomOptions& boom : rig.engine.booms) fmt::print(" {}", boom.name);
  fmt::print("\n");
  print_feed_reach(checked);
  print_can(rig);
  print_modbus(rig);
  print_udp(rig);
  print_osc(rig);
}

struct CheckArguments {
  std::string rig;
  bool probe = false, json = false;
};

void check(const CheckArguments& options) {
  config::Rig rig = config::load_rig(options.rig);
  config::check_paths(rig);
  SoundSet sounds = config::load_sounds(rig);
  const CheckedRig checked = checked_rig(rig, sounds);
  const Engine engine = config::build_engine(rig, sounds);  // builds every table the daemon would
  if (options.json)
    print_document(check_json(checked));
  else
    print_text(checked);
  for (const std::string& doubt : rig.doubts) fmt::print(stderr, "{}\n", doubt);
  for (const std::string& missing : checked.missing) fmt::print(stderr, "{}\n", missing);
  if (options.probe) probe_modbus(rig);
}

}  // namespace

void add_check(cli::Verb& program) {
  cli::Verb verb = program.verb("check", "Validate everything the daemon would load").group(kInspect);
  auto options = std::make_shared<CheckArguments>();
  verb.positional("RIG.toml", options->rig, "the rig").required();
  const cli::Option probe =
      verb.flag("--probe", options->probe,
                "also read every Modbus register once: live values, 32 bit ones in all four word orders");
  verb.flag("--json", options->json, "the summary as one JSON document").excludes(probe);
  verb.callback([options] { check(*options); });
  verb.details(
      "Prints `ok` and a summary, or one line FILE:LINE: KEY: what is wrong, what was expected (exit code "
      "1).");
  verb.example("rigsound check config/rigs/demo.toml");
  verb.example("rigsound check config/rigs/demo.toml --json");
}

}  // namespace rigsound::tools
