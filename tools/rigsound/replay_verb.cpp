#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "rigsound/can/can_sender.hpp"
#include "rigsound/log/candump.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/replay_clock.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/modbus/modbus_writer.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Options {
  std::string log, can, modbus;
  double speed = 1;
  bool json = false;
};

struct Skips {
  std::uint64_t refused = 0;     ///< by the interface or the device
  std::uint64_t unwritable = 0;  ///< error frames; values read from tables that cannot be written
  std::uint64_t waits = 0;       ///< for a full queue
};

void report(const Options& o, const log::ReplayClock& clock, const Skips& skips) {
  const nlohmann::ordered_json json = {{"sent", clock.entries()},
                                       {"late_mean_ms", clock.mean_late_s() * 1e3},
                                       {"late_worst_ms", clock.worst_late_s() * 1e3},
                                       {"refused", skips.refused},
                                       {"not_sent", skips.unwritable},
                                       {"queue_full", skips.waits}};
  if (o.json) return fmt::print("{}\n", json.dump());
  for (const auto& [key, value] : json.items())
    value.is_number_float() ? fmt::print("{} {:.3f}\n", key, value.get<double>())
                            : fmt::print("{} {}\n", key, value.get<std::uint64_t>());
}

void replay_can(const Options& o) {
  if (log::is_capture(o.log))
    throw InputError(o.log, "is a capture of Modbus/TCP, expected a CAN log for --can");
  log::CandumpReader reader(o.log);
  can::CanSender bus(o.can);
  log::ReplayClock clock(o.speed);
  log::CanRecord record;
  Skips skips;
  while (reader.next(record)) {
    if (record.frame.error) {  // made by a controller, not by a sender
      ++skips.unwritable;
      continue;
    }
    clock.wait_for(record.time_ns);
    if (!bus.send(record.frame)) ++skips.refused;
    clock.sent();
  }
  skips.waits = bus.waits();
  report(o, clock, skips);
}

void replay_modbus(const Options& o) {
  if (!log::is_capture(o.log)) throw InputError(o.log, "is no pcap or pcapng, expected one for --modbus");
  log::ModbusCapture capture(o.log);
  modbus::ModbusWriter device(o.modbus);
  log::ReplayClock clock(o.speed);
  log::TimedExchange entry;
  Skips skips;
  while (capture.next(entry)) {
    const modbus::Table table = entry.exchange.table;
    if (table != modbus::Table::kHolding && table != modbus::Table::kCoil) {
      ++skips.unwritable;
      continue;
    }
    clock.wait_for(entry.time_ns);
    if (!device.write(entry.exchange)) ++skips.refused;
    clock.sent();
  }
  report(o, clock, skips);
}

}  // namespace

void add_replay(cli::Verb& program) {
  cli::Verb verb = program.verb("replay", "Play a bus log onto a bus, at its own pace").group(kRun);
  auto options = std::make_shared<Options>();
  verb.positional("BUS.log", options->log, "candump -l log, or Modbus/TCP as pcap or pcapng").required();
  cli::Verb target = verb.exactly_one("Target");
  target.option("--can", options->can, "interface to send the frames on; the log's names do not count");
  target.option("--modbus", options->modbus, "HOST:PORT of a server to write the values to");
  verb.option("--speed", options->speed, "2: twice as fast").range(0.001, 1000).shows_default();
  verb.flag("--json", options->json, "figures as one JSON object");
  verb.callback([options] { options->can.empty() ? replay_modbus(*options) : replay_can(*options); });
  verb.details(
      "Prints how many entries were sent and how late (mean, worst; deadlines are absolute, lateness does "
      "not add "
      "up). A full queue is waited for. Of Modbus, what was written or read in holding registers and coils "
      "is "
      "written.");
  verb.example("rigsound replay config/logs/shift.log --can vcan0");
}

}  // namespace rigsound::tools
