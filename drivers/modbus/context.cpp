#include "modbus/context.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <cerrno>
#include <cmath>

#include "rigsound/device_error.hpp"

namespace rigsound::modbus {
namespace {

// It carries no parity bit, and from its second opening on tcsetattr() calls the wish for one EINVAL.
bool is_pseudo_terminal(const std::string& device) {
  constexpr unsigned kFirstMajor = 136, kLastMajor = 143;  // Unix98 slaves, admin-guide/devices.txt
  struct stat s {};
  if (::stat(device.c_str(), &s) != 0 || !S_ISCHR(s.st_mode)) return false;
  return major(s.st_rdev) >= kFirstMajor && major(s.st_rdev) <= kLastMajor;
}

modbus_t* new_context(const ModbusOptions& o) {
  if (o.transport == Transport::kTcp)
    return modbus_new_tcp_pi(o.host.c_str(), std::to_string(o.port).c_str());
  // libmodbus frames RTU on whatever descriptor it is lent; the device is never opened.
  if (o.transport == Transport::kRtuTcp) return modbus_new_rtu("/dev/null", 19200, 'N', 8, 1);
  const char parity = is_pseudo_terminal(o.address) ? 'N' : o.parity;
  return modbus_new_rtu(o.address.c_str(), o.baud, parity, 8, o.stop_bits);
}

}  // namespace

Context make_context(const ModbusOptions& o) {
  Context context(new_context(o));
  if (!context || modbus_set_slave(context.get(), o.unit) != 0)
    throw DeviceError(o.address + ": " + modbus_strerror(errno));
  const double whole = std::floor(o.timeout_s);
  modbus_set_response_timeout(context.get(), static_cast<std::uint32_t>(whole),
                              static_cast<std::uint32_t>((o.timeout_s - whole) * 1e6));
  modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
  return context;
}

}  // namespace rigsound::modbus
