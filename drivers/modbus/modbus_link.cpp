#include "rigsound/modbus/modbus_link.hpp"

#include "modbus/client.hpp"
#include "modbus/rtu_server.hpp"
#include "modbus/tcp_server.hpp"

namespace rigsound::modbus {

void ModbusLink::run(const std::atomic<bool>& stop) {
  while (!stop.load(std::memory_order_relaxed)) step();
}

ModbusCounters ModbusLink::counters() const noexcept {
  const auto read = [](const std::atomic<std::uint64_t>& x) { return x.load(std::memory_order_relaxed); };
  return {read(count_.requests),    read(count_.refused), read(count_.bad_frames),
          read(count_.turned_away), read(count_.lost),    read(count_.connections)};
}

std::unique_ptr<ModbusLink> make_modbus_link(const ModbusOptions& options, ModbusListener& listener) {
  if (options.role == Role::kClient) return std::make_unique<Client>(options, listener);
  if (options.transport == Transport::kTcp) return std::make_unique<TcpServer>(options, listener);
  return std::make_unique<RtuServer>(options, listener);
}

}  // namespace rigsound::modbus
