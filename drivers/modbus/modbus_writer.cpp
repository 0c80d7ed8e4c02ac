#include "rigsound/modbus/modbus_writer.hpp"

#include <cerrno>

#include "modbus/context.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::modbus {
namespace {

ModbusOptions options_of(const std::string& address) {
  const auto where = parse_host_port(address, kPort);
  if (!where) throw DeviceError("modbus " + address + ": is no address, expected HOST:PORT or [V6]:PORT");
  ModbusOptions options;
  options.address = address;
  options.timeout_s = 2;
  options.host = where->host;
  options.port = where->port;
  return options;
}

}  // namespace

struct ModbusWriter::Link {
  std::string address;
  Context context;
};

ModbusWriter::ModbusWriter(const std::string& address)
    : link_(new Link{address, make_context(options_of(address))}) {
  if (modbus_connect(link_->context.get()) != 0)
    throw DeviceError("modbus " + address + ": cannot be reached: " + modbus_strerror(errno));
}

ModbusWriter::~ModbusWriter() = default;

bool ModbusWriter::write(const Exchange& e) {
  modbus_t* const c = link_->context.get();
  const auto count = static_cast<int>(e.values.size());
  modbus_set_slave(c, e.unit);
  int wrote = -1;
  if (e.table == Table::kCoil) {
    const std::vector<std::uint8_t> bits(e.values.begin(), e.values.end());
    wrote = modbus_write_bits(c, e.address, count, bits.data());
  } else if (count == 1) {
    wrote = modbus_write_register(c, e.address, e.values.front());
  } else {
    wrote = modbus_write_registers(c, e.address, count, e.values.data());
  }
  if (wrote == count) return true;
  const int error = errno;
  if (error >= EMBXILFUN && error <= EMBXGTAR) return false;
  throw DeviceError("modbus " + link_->address + ": " + modbus_strerror(error));
}

}  // namespace rigsound::modbus
