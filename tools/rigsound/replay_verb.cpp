#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <type_traits>

#include "log_arguments.hpp"
#include "progress_bar.hpp"
#include "rigsound/can/can_sender.hpp"
#include "rigsound/config/json.hpp"
#include "rigsound/log/can_reader.hpp"
#include "rigsound/log/log_clock.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/placed_entries.hpp"
#include "rigsound/log/replay_clock.hpp"
#include "rigsound/log/udp_capture.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/modbus/modbus_writer.hpp"
#include "rigsound/udp/udp_sender.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct ReplayArguments {
  LogArguments log;
  std::string modbus, udp;
  double speed = 1;
  bool json = false;
};

struct Skips {
  std::uint64_t refused = 0;     ///< by the interface or the device
  std::uint64_t unwritable = 0;  ///< error frames; values read from tables that cannot be written
  std::uint64_t waits = 0;       ///< for a full queue
};

void report(const ReplayArguments& o, const log::ReplayClock& clock, const Skips& skips) {
  const Json json = {{"sent", clock.entries()},
                     {"late_mean_ms", clock.mean_late_s() * 1e3},
                     {"late_worst_ms", clock.worst_late_s() * 1e3},
                     {"refused", skips.refused},
                     {"not_sent", skips.unwritable},
                     {"queue_full", skips.waits}};
  if (o.json) return fmt::print("{}\n", config::json_line(json));
  for (const auto& [key, value] : json.items())
    value.is_number_float() ? fmt::print("{} {:.3f}\n", key, value.get<double>())
                            : fmt::print("{} {}\n", key, value.get<std::uint64_t>());
}

/// Where the frames of which interface of the log go.
class CanTargets {
 public:
  /// `words`: one IFACE for all, or LOG=IFACE for each.
  explicit CanTargets(const std::vector<std::string>& words) {
    if (words.size() == 1 && words.front().find('=') == std::string::npos) {
      all_ = &sender(words.front());
      return;
    }
    for (const std::string& word : words) {
      const auto [from, to] = interface_pair(word);
      by_interface_[from] = &sender(to);
    }
  }

  /// Nullptr when nobody wants the interface's frames.
  can::CanSender* of(const std::string& interface) {
    if (all_ != nullptr) return all_;
    const auto found = by_interface_.find(interface);
    return found == by_interface_.end() ? nullptr : found->second;
  }

  std::uint64_t waits() const {
    std::uint64_t sum = 0;
    for (const auto& [name, sender] : senders_) sum += sender.waits();
    return sum;
  }

 private:
  can::CanSender& sender(const std::string& name) { return senders_.try_emplace(name, name).first->second; }

  std::map<std::string, can::CanSender> senders_;
  std::map<std::string, can::CanSender*> by_interface_;
  can::CanSender* all_ = nullptr;
};

void print_notes(const ReplayArguments& o, const log::LogClock& times) {
  for (const log::LogNote& note : times.notes()) fmt::print(stderr, "{}: {}\n", o.log.log, note.text);
}

void require_sent(const log::LogFile& file, const log::ReplayClock& clock,
                  const std::set<std::string>& seen) {
  if (clock.entries() > 0) return;
  throw InputError(file.name(), seen.empty()
                                    ? "holds nothing to send, expected a bus log"
                                    : "has frames of " + list_of(seen) + " only, expected those of --can");
}

/// The time of the last entry, since the first; what was read is read again. 0 when nobody sees the progress.
template <class Entry, class Capture>
double length_ns(Capture&& capture, const ReplayArguments& o) {
  if (!ProgressBar().seen()) return 0;
  log::PlacedEntries<std::remove_reference_t<Capture>, Entry> entries(o.log.longest_gap_s());
  while (entries.front(capture) != nullptr) entries.pop();
  return static_cast<double>(entries.time_ns());
}

/// Shows which share of a log was sent.
class ShownReplay {
 public:
  explicit ShownReplay(double length_ns) : length_ns_(length_ns) {}
  void at(std::int64_t time_ns) {
    if (length_ns_ > 0) bar_.show(static_cast<double>(time_ns) / length_ns_);
  }

 private:
  double length_ns_;
  ProgressBar bar_;
};

void replay_can(const ReplayArguments& o) {
  const log::LogFile file(o.log.log);
  std::optional<ShownReplay> shown(length_ns<log::CanRecord>(*log::open_can_reader(file), o));
  const auto reader = log::open_can_reader(file);
  CanTargets targets(o.log.can);
  log::PlacedEntries<log::CanReader, log::CanRecord> entries(o.log.longest_gap_s());
  log::ReplayClock clock(o.speed);
  Skips skips;
  std::set<std::string> seen;
  for (; const log::CanRecord* record = entries.front(*reader); entries.pop()) {
    seen.insert(record->interface);
    can::CanSender* const bus = targets.of(record->interface);
    if (record->frame.error || bus == nullptr) {  // an error frame is made by a controller, not by a sender
      ++skips.unwritable;
      continue;
    }
    shown->at(entries.time_ns());
    clock.wait_for(entries.time_ns());
    if (!bus->send(record->frame)) ++skips.refused;
    clock.sent();
  }
  shown.reset();
  require_sent(file, clock, seen);
  skips.waits = targets.waits();
  report(o, clock, skips);
  print_notes(o, entries.clock());
}

void replay_modbus(const ReplayArguments& o) {
  const log::LogFile file(o.log.log);
  std::optional<ShownReplay> shown(length_ns<log::TimedExchange>(log::ModbusCapture(file), o));
  log::ModbusCapture capture(file);
  modbus::ModbusWriter device(o.modbus);
  log::PlacedEntries<log::ModbusCapture, log::TimedExchange> entries(o.log.longest_gap_s());
  log::ReplayClock clock(o.speed);
  Skips skips;
  for (; const log::TimedExchange* entry = entries.front(capture); entries.pop()) {
    const modbus::Table table = entry->exchange.table;
    if (table != modbus::Table::kHolding && table != modbus::Table::kCoil) {
      ++skips.unwritable;
      continue;
    }
    shown->at(entries.time_ns());
    clock.wait_for(entries.time_ns());
    if (!device.write(entry->exchange)) ++skips.refused;
    clock.sent();
  }
  shown.reset();
  require_sent(file, clock, {});
  report(o, clock, skips);
  print_notes(o, entries.clock());
}

void replay_udp(const ReplayArguments& o) {
  const log::LogFile file(o.log.log);
  std::optional<ShownReplay> shown(length_ns<log::TimedDatagram>(log::UdpCapture(file, {}), o));
  log::UdpCapture capture(file, {});
  const udp::UdpSender device(o.udp);
  log::PlacedEntries<log::UdpCapture, log::TimedDatagram> entries(o.log.longest_gap_s());
  log::ReplayClock clock(o.speed);
  Skips skips;
  for (; const log::TimedDatagram* entry = entries.front(capture); entries.pop()) {
    shown->at(entries.time_ns());
    clock.wait_for(entries.time_ns());
    if (!device.send(entry->text)) ++skips.refused;
    clock.sent();
  }
  shown.reset();
  require_sent(file, clock, {});
  report(o, clock, skips);
  print_notes(o, entries.clock());
}

void replay(const ReplayArguments& o) {
  if (!o.udp.empty()) return replay_udp(o);
  o.log.can.empty() ? replay_modbus(o) : replay_can(o);
}

}  // namespace

void add_replay(cli::Verb& program) {
  cli::Verb verb = program.verb("replay", "Play a bus log onto a bus, at its own pace").group(kRun);
  auto options = std::make_shared<ReplayArguments>();
  verb.positional("BUS.log", options->log.log, kLogHelp).required();
  cli::Verb target = verb.exactly_one("Target");
  target
      .option(
          "--can", options->log.can,
          "interface to send the frames on, whatever the log calls it; or LOG=IFACE, once for each interface")
      .repeatable();
  target.option("--modbus", options->modbus, "HOST:PORT of a server to write the values to");
  target.option("--udp", options->udp, "HOST:PORT to send the datagrams to");
  add_gap_option(verb, options->log);
  verb.option("--speed", options->speed, "2: twice as fast").range(0.001, 1000).shows_default();
  verb.flag("--json", options->json, "figures as one JSON document");
  verb.callback([options] { replay(*options); });
  verb.details(
      "Prints how many entries were sent and how late (mean, worst; deadlines are absolute, lateness does "
      "not add "
      "up). A full queue is waited for. Of Modbus, what was written or read in holding registers and coils "
      "is "
      "written.");
  verb.example("rigsound replay config/logs/shift.log --can vcan0");
  verb.example("rigsound replay config/logs/shift.log --can vcan0 --json");
}

}  // namespace rigsound::tools
