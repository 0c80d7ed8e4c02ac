#include "rigsound/modbus/probe.hpp"

#include <cerrno>
#include <chrono>
#include <thread>

#include "modbus/context.hpp"
#include "modbus/table_reader.hpp"

namespace rigsound::modbus {
namespace {

void pause(const ModbusOptions& options) {
  std::this_thread::sleep_for(std::chrono::duration<double>(options.pause_s));
}

Context connected(const ModbusOptions& options) {
  Context context = make_context(options);
  connect(context.get(), options);
  pause(options);
  return context;
}

}  // namespace

std::vector<Probed> probe(const ModbusOptions& options) {
  Context context = connected(options);
  bool fresh = true;
  std::vector<Probed> found;
  for (const RegisterRoute& route : options.routes) {
    const PollRequest request{route.table, route.address, width(route)};
    Exchange answer;
    bool good = read_table(context.get(), options.unit, request, answer);
    if (!good && !is_exception(errno) && !fresh) {  // a device that closes after each answer
      context = connected(options);
      good = read_table(context.get(), options.unit, request, answer);
    }
    const int error = errno;
    if (!good && !is_exception(error)) context = connected(options);
    fresh = !good && !is_exception(error);
    found.push_back(
        {good ? answer.values : std::vector<std::uint16_t>(), good ? "" : modbus_strerror(error)});
    pause(options);
  }
  return found;
}

}  // namespace rigsound::modbus
