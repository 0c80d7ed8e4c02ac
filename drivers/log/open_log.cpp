#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/can_log.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/modbus_log.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {

std::string seconds_text(double seconds) {
  const auto tenths = static_cast<std::int64_t>(seconds * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::unique_ptr<BusLog> open_log(const std::filesystem::path& file, const std::vector<can::CanOptions>& can,
                                 const std::vector<modbus::ModbusOptions>& modbus) {
  if (is_capture(file)) {
    if (modbus.empty())
      throw InputError(file.string(), "is a capture of Modbus/TCP, expected a rig with a [[modbus]]");
    return std::make_unique<ModbusLog>(file, modbus);
  }
  if (can.empty()) throw InputError(file.string(), "is a CAN log, expected a rig with a [[can]]");
  return std::make_unique<CanLog>(file, can);
}

}  // namespace rigsound::log
