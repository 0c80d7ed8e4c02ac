#include "modbus/modbus_bus.hpp"

#include "modbus/client.hpp"
#include "modbus/rtu_server.hpp"
#include "modbus/tcp_server.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::modbus {

ModbusBus::ModbusBus(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : BusBase("modbus " + options.address, targets(options.routes), listener), options_(options), tap_(tap) {}

void ModbusBus::report_exchange(const Exchange& exchange) {
  if (tap_ != nullptr) tap_->traffic(&exchange, 1);
  std::vector<Reading> values;
  readings(exchange, options_.routes, monotonic_s(), values);
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
          {"losses", read(count_.lost)}};
}

std::unique_ptr<Bus> make_bus(const ModbusOptions& options, BusListener& listener, ModbusTap* tap) {
  if (options.role == Role::kClient) return std::make_unique<Client>(options, listener, tap);
  if (options.transport == Transport::kTcp) return std::make_unique<TcpServer>(options, listener, tap);
  return std::make_unique<RtuServer>(options, listener, tap);
}

}  // namespace rigsound::modbus
