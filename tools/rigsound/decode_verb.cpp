#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "log_arguments.hpp"
#include "log_notes.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/log/change_trace.hpp"
#include "rigsound/machine/input_error.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Options {
  std::string rig;
  LogArguments log;
};

std::vector<SignalId> watched(const config::Rig& rig) {
  std::vector<SignalId> ids;
  for (const can::CanOptions& bus : rig.can)
    for (const can::SignalRoute& route : bus.routes) ids.push_back(route.target);
  for (const modbus::ModbusOptions& link : rig.modbus)
    for (const modbus::RegisterRoute& route : link.routes) ids.push_back(route.target);
  for (const udp::UdpOptions& input : rig.udp)
    for (const udp::NameRoute& route : input.routes) ids.push_back(route.target);
  return ids;
}

std::string value_text(const log::Change& change) {
  const std::string_view word = value_word(change.signal.signal, change.value);
  return word.empty() ? fmt::format("{:.10g}", change.value) : std::string(word);
}

void decode(const Options& options) {
  const config::Rig rig = config::load_rig(options.rig);
  const std::unique_ptr<log::BusLog> log =
      log::open_log(options.log.log, {rig.can, rig.modbus, rig.udp}, log_options(options.log));
  std::string csv = "time_s,signal,value\n";  // printed whole or not at all
  log::trace_changes(*log, rig.safety, watched(rig), [&](const log::Change& change) {
    fmt::format_to(std::back_inserter(csv), "{:.6f},{},{}\n", change.time_s,
                   config::signal_label(rig, change.signal), value_text(change));
  });
  std::fwrite(csv.data(), 1, csv.size(), stdout);
  print_log_notes(options.log.log, *log, rig);
}

}  // namespace

void add_decode(cli::Verb& program) {
  cli::Verb verb = program.verb("decode", "Print what a recorded bus would tell the engine").group(kInspect);
  auto options = std::make_shared<Options>();
  verb.positional("RIG.toml", options->rig, "the rig; a bus and its signals are enough").required();
  verb.option("--log", options->log.log, kLogHelp).required();
  add_log_options(verb, options->log);
  verb.callback([options] { decode(*options); });
  verb.details(
      "Prints CSV time_s,signal,value: one row for the first valid value of a signal and one at each change. "
      "time_s counts from the first entry of the log. Values are those after the rig's [safety] rules, in "
      "the "
      "signal's unit, or words (none, closed, open; off, on). Signals of a second boom are NAME.signal. With "
      "one "
      "[[can]] and one interface in the log their names need not agree.");
  verb.example("rigsound decode config/rigs/demo.toml --log config/logs/shift.log");
}

}  // namespace rigsound::tools
