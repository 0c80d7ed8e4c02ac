#include "modbus/modbus_bus.hpp"

#include <algorithm>

#include "modbus/client.hpp"
#include "modbus/rtu_server.hpp"
#include "modbus/tcp_server.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::modbus {

ModbusBus::ModbusBus(const std::string& address, const std::vector<RegisterRoute>& routes,
                     BusListener& listener, ModbusTap* tap)
    : BusBase("modbus " + address, targets(routes), listener), tap_(tap) {}

void ModbusBus::report_exchange(const Exchange& exchange, const std::vector<RegisterRoute>& routes) {
  if (tap_ != nullptr) tap_->traffic(&exchange, 1);
  std::vector<Reading> values;
  readings(exchange, routes, monotonic_s(), values);
  report(values);
}

std::vector<BusCounter> ModbusBus::counters() const {
  const auto read = [](const std::atomic<std::uint64_t>& x) { return x.load(std::memory_order_relaxed); };
  const std::uint64_t requests = read(count_.requests), refused = read(count_.refused),
                      bad_frames = read(count_.bad_frames);
  return {{"frames_seen", requests + refused + bad_frames},
          {"frames_used", requests},
          {"frames_bad", bad_frames},
          {"requests_refused", refused},
          {"rejected_connections", read(count_.rejected_connections)},
          {"evicted_connections", read(count_.evicted_connections)},
          {"losses", read(count_.lost)}};
}

std::vector<Line> lines(const std::vector<ModbusOptions>& sections) {
  std::vector<Line> lines;
  for (const ModbusOptions& section : sections) {
    const auto same = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
      return section.role == Role::kClient && line.front().role == Role::kClient &&
             line.front().address == section.address;
    });
    if (same == lines.end())
      lines.push_back({section});
    else
      same->push_back(section);
  }
  return lines;
}

std::unique_ptr<Bus> make_bus(const Line& line, BusListener& listener, ModbusTap* tap) {
  const ModbusOptions& first = line.front();
  if (first.role == Role::kClient) return std::make_unique<Client>(line, listener, tap);
  if (first.transport != Transport::kRtu) return std::make_unique<TcpServer>(first, listener, tap);
  return std::make_unique<RtuServer>(first, listener, tap);
}

}  // namespace rigsound::modbus
