#include "log/can_capture.hpp"
#include "log/tcp_packet.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/can_log.hpp"
#include "rigsound/log/modbus_log.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

enum class Captured : std::uint8_t { kNothing, kCan, kTcp };

/// What the first packet is that is CAN or TCP.
Captured what_is_in(const LogFile& file) {
  CaptureFile capture(file);
  CapturedPacket packet;
  while (capture.next(packet)) {
    if (parse_can_packet(packet)) return Captured::kCan;
    if (parse_packet(packet.link_type, packet.bytes.data(), packet.bytes.size())) return Captured::kTcp;
  }
  return Captured::kNothing;
}

}  // namespace

std::unique_ptr<BusLog> open_log(const std::filesystem::path& path, const std::vector<can::CanOptions>& can,
                                 const std::vector<modbus::ModbusOptions>& modbus,
                                 const LogOptions& options) {
  LogFile file(path);
  const bool is_capture = format_of(file) == LogFormat::kCapture;
  const Captured captured = is_capture ? what_is_in(file) : Captured::kNothing;
  if (is_capture && captured == Captured::kNothing)
    throw InputError(file.name(), "is a capture without CAN and without TCP, expected one of them");
  if (captured == Captured::kTcp) {
    if (modbus.empty())
      throw InputError(file.name(), "is a capture of Modbus/TCP, expected a rig with a [[modbus]]");
    return std::make_unique<ModbusLog>(std::move(file), modbus, options);
  }
  if (can.empty()) throw InputError(file.name(), "is a CAN log, expected a rig with a [[can]]");
  return std::make_unique<CanLog>(std::move(file), can, options);
}

}  // namespace rigsound::log
