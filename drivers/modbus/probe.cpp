#include "rigsound/modbus/probe.hpp"

#include <chrono>
#include <memory>
#include <thread>

#include "modbus/client_link.hpp"

namespace rigsound::modbus {
namespace {

void pause(const ModbusOptions& options) {
  std::this_thread::sleep_for(std::chrono::duration<double>(options.pause_s));
}

}  // namespace

std::vector<Probed> probe(const ModbusOptions& options) {
  const StopEvent never;
  std::unique_ptr<ClientLink> link;
  const auto connect = [&] {
    link.reset();  // a device may take one connection only
    link = std::make_unique<ClientLink>(options, never);
    pause(options);
  };
  connect();
  bool fresh = true;
  std::vector<Probed> found;
  for (const RegisterRoute& route : options.routes) {
    const PollRequest request{route.table, route.address, width(route)};
    Exchange answer;
    int error = link->read(options.unit, request, answer);
    if (error != 0 && !is_exception(error) && !fresh) {  // a device that closes after each answer
      connect();
      error = link->read(options.unit, request, answer);
    }
    fresh = error != 0 && !is_exception(error);
    if (fresh) connect();
    found.push_back({error == 0 ? answer.values : std::vector<std::uint16_t>(),
                     error == 0 ? "" : modbus_strerror(error)});
    pause(options);
  }
  return found;
}

}  // namespace rigsound::modbus
