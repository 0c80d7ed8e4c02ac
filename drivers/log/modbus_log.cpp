#include "rigsound/log/modbus_log.hpp"

#include <algorithm>
#include <set>

#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr int kAnyUnit = 255;

std::vector<ServerPort> ports_of(const std::vector<modbus::ModbusOptions>& buses) {
  std::vector<ServerPort> ports;
  for (const modbus::ModbusOptions& bus : buses)
    if (bus.transport != modbus::Transport::kRtu)
      ports.push_back({bus.port, bus.transport == modbus::Transport::kRtuTcp});
  return ports;
}

bool is_address(const std::string& host) {
  const bool v6 = host.find(':') != std::string::npos;
  return v6 || (!host.empty() && host.find_first_not_of("0123456789.") == std::string::npos);
}

/// Whether the bus means this server: a server listens at any address, and a name may be any.
bool is_server_of(const modbus::ModbusOptions& bus, const std::string& server) {
  if (bus.transport == modbus::Transport::kRtu) return false;
  if (server == text_of({bus.host, bus.port})) return true;
  const bool any_host = bus.role == modbus::Role::kServer || !is_address(bus.host);
  const std::string port = ":" + std::to_string(bus.port);
  return any_host && server.size() > port.size() &&
         server.compare(server.size() - port.size(), port.size(), port) == 0;
}

bool is_rtu_over_tcp(const LogFile& file, std::vector<ServerPort> ports) {
  if (ports.empty()) ports.emplace_back();
  for (ServerPort& port : ports) port.rtu_frames = true;
  ModbusCapture capture(file, ports);
  TimedExchange entry;
  return capture.next(entry);
}

/// The addresses of a table that a unit of a server was asked for.
struct Span {
  int first = 65535, last = 0;
};

/// What a capture holds, for the user whose rig finds nothing in it.
class Contents {
 public:
  void add(const TimedExchange& entry) {
    const modbus::Exchange& e = entry.exchange;
    const auto key = std::make_pair(text_of(entry.server), e.unit);
    Span& span = spans_[key][e.table];
    span.first = std::min<int>(span.first, e.address);
    span.last = std::max(span.last, e.address + static_cast<int>(e.values.size()) - 1);
  }

  std::string text() const {
    std::string text;
    for (const auto& [key, tables] : spans_) {
      text += (text.empty() ? "" : "; ") + key.first + " unit " + std::to_string(key.second) + ": ";
      bool more = false;
      for (const auto& [table, span] : tables) {
        text += (more ? ", " : "") + modbus::describe(table, static_cast<std::uint16_t>(span.first)) +
                " to " + std::to_string(span.last);
        more = true;
      }
    }
    return text;
  }

 private:
  std::map<std::pair<std::string, int>, std::map<modbus::Table, Span>> spans_;
};

std::string wishes(const std::vector<modbus::ModbusOptions>& buses) {
  std::string text;
  for (const modbus::ModbusOptions& bus : buses) {
    text += (text.empty() ? "" : "; ") + bus.address +
            (bus.unit == kAnyUnit ? " any unit" : " unit " + std::to_string(bus.unit)) + ": ";
    for (std::size_t i = 0; i < bus.routes.size(); ++i)
      text += (i > 0 ? ", " : "") + modbus::describe(bus.routes[i].table, bus.routes[i].address);
  }
  return text;
}

}  // namespace

ModbusLog::ModbusLog(LogFile file, const std::vector<modbus::ModbusOptions>& buses, const LogOptions& options)
    : file_(std::move(file)), buses_(buses), entries_(options.longest_gap_s) {
  survey();
  capture_ = std::make_unique<ModbusCapture>(file_, ports_of(buses_));
}

/// Reads the whole capture once: which servers it knows, and whether it is of use.
void ModbusLog::survey() {
  std::set<std::string> servers;
  Contents contents;
  std::uint64_t exchanges = 0;
  const auto each = [&](const auto& visit) {
    ModbusCapture capture(file_, ports_of(buses_));
    TimedExchange entry;
    while (capture.next(entry))
      if (!visit(entry)) return;
  };
  each([&](const TimedExchange& entry) {
    ++exchanges;
    servers.insert(text_of(entry.server));
    contents.add(entry);
    return true;
  });
  if (exchanges == 0)
    throw InputError(file_.name(), "holds no Modbus/TCP exchange, expected requests and their answers" +
                                       std::string(is_rtu_over_tcp(file_, ports_of(buses_))
                                                       ? ": it is RTU over TCP, transport = \"rtu_tcp\"?"
                                                       : ""));
  choose_servers({servers.begin(), servers.end()});

  SignalBoard scratch;
  bool useful = false;
  std::vector<Reading> readings;
  std::optional<Reading> refused;
  each([&](const TimedExchange& entry) {
    readings.clear();
    for (std::size_t bus = 0; bus < buses_.size(); ++bus) read_for(bus, entry, 0, readings);
    for (const Reading& reading : readings) {
      const bool good = scratch.take(reading) == Validity::kValid;
      useful = useful || good;
      if (!good && !refused) refused = reading;
    }
    return !useful;
  });
  if (useful) return;
  const std::string head = "none of its " + std::to_string(exchanges) + " exchanges is of use to the rig: ";
  if (refused) {
    const SignalInfo& signal = info(refused->id.signal);
    throw InputError(file_.name(), head + std::string(signal.name) + " is " + number_text(refused->value) +
                                       ", but goes from " + number_text(signal.min) + " to " +
                                       number_text(signal.max) + ": another type, word_order or scale?");
  }
  throw InputError(file_.name(), head + "it holds " + contents.text() + "; the rig wants " + wishes(buses_));
}

void ModbusLog::choose_servers(const std::vector<std::string>& servers) {
  server_.assign(buses_.size(), std::nullopt);
  bool any_known = false;
  for (std::size_t bus = 0; bus < buses_.size(); ++bus)
    for (const std::string& server : servers)
      if (!server_[bus] && is_server_of(buses_[bus], server)) {
        server_[bus] = server;
        any_known = true;
      }
  if (!any_known && servers.size() == 1) return;
  const auto on_tcp = [](const modbus::ModbusOptions& bus) {
    return bus.transport != modbus::Transport::kRtu;
  };
  if (!any_known && std::any_of(buses_.begin(), buses_.end(), on_tcp))
    throw InputError(file_.name(), "has the servers " + list_of(servers) + ", expected " +
                                       std::find_if(buses_.begin(), buses_.end(), on_tcp)->address +
                                       " of the rig among them");
  for (std::size_t bus = 0; bus < buses_.size(); ++bus) {
    if (server_[bus] || !on_tcp(buses_[bus])) continue;
    server_[bus] = buses_[bus].address;
    notes_.push_back({"holds nothing of " + buses_[bus].address + ", it has " + list_of(servers)});
  }
}

void ModbusLog::read_for(std::size_t bus, const TimedExchange& entry, double time_s,
                         std::vector<Reading>& out) const {
  const modbus::ModbusOptions& options = buses_[bus];
  if (options.unit != kAnyUnit && options.unit != entry.exchange.unit) return;
  if (server_[bus] && *server_[bus] != text_of(entry.server)) return;
  modbus::readings(entry.exchange, options.routes, time_s, out);
}

std::optional<double> ModbusLog::next_s() {
  return entries_.front(*capture_) != nullptr ? std::optional<double>(entries_.time_s()) : std::nullopt;
}

bool ModbusLog::read_until(double until_s, SignalBoard& board) {
  std::vector<Reading> readings;
  bool told = false;
  while (const TimedExchange* entry = entries_.front(*capture_)) {
    if (entries_.time_s() > until_s) break;
    readings.clear();
    for (std::size_t bus = 0; bus < buses_.size(); ++bus) read_for(bus, *entry, entries_.time_s(), readings);
    bool good = false;
    for (const Reading& reading : readings) good = board.take(reading) == Validity::kValid || good;
    used_ += good ? 1 : 0;
    told = told || !readings.empty();
    entries_.pop();
  }
  return told;
}

std::vector<LogNote> ModbusLog::notes() const {
  const CaptureCounts& c = capture_->counts();
  const auto text = [](std::uint64_t n) { return std::to_string(n); };
  std::vector<LogNote> notes = {{text(c.exchanges) + " exchanges in " + seconds_text(entries_.time_s()) +
                                 " s, " + text(used_) + " used"}};
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  if (c.refused > 0) notes.push_back({text(c.refused) + " requests were refused by the device"});
  if (c.unpaired > 0) notes.push_back({text(c.unpaired) + " answers fit no request of the capture"});
  if (c.other_functions > 0)
    notes.push_back({text(c.other_functions) + " requests neither read nor wrote values"});
  if (c.other > 0) notes.push_back({text(c.other) + " packets are no Modbus/TCP"});
  const std::vector<LogNote> of_clock = entries_.clock().notes();
  notes.insert(notes.end(), of_clock.begin(), of_clock.end());
  return notes;
}

}  // namespace rigsound::log
