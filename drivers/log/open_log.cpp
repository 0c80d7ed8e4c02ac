#include "log/can_capture.hpp"
#include "log/ip_packet.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/can_log.hpp"
#include "rigsound/log/modbus_log.hpp"
#include "rigsound/log/udp_log.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

/// What the packets of a capture are.
struct Captured {
  bool can = false, tcp = false, udp = false;
};

/// Reads no further than it takes to find a bus that the rig has.
Captured what_is_in(const LogFile& file, const Buses& buses) {
  CaptureFile capture(file);
  CapturedPacket packet;
  Captured found;
  const auto decided = [&] {
    return (found.can && !buses.can.empty()) || (found.tcp && !buses.modbus.empty()) ||
           (found.udp && !buses.udp.empty());
  };
  while (!decided() && capture.next(packet)) {
    const std::uint8_t* const bytes = packet.bytes.data();
    found.can = found.can || parse_can_packet(packet);
    found.tcp = found.tcp || parse_packet(packet.link_type, bytes, packet.bytes.size());
    found.udp = found.udp || parse_udp_packet(packet.link_type, bytes, packet.bytes.size());
  }
  return found;
}

std::unique_ptr<BusLog> open_capture(LogFile file, const Buses& buses, const LogOptions& options) {
  const Captured found = what_is_in(file, buses);
  if (found.can && !buses.can.empty()) return std::make_unique<CanLog>(std::move(file), buses.can, options);
  if (found.tcp && !buses.modbus.empty())
    return std::make_unique<ModbusLog>(std::move(file), buses.modbus, options);
  if (found.udp && !buses.udp.empty()) return std::make_unique<UdpLog>(std::move(file), buses.udp, options);
  if (found.can) throw InputError(file.name(), "is a capture of CAN, expected a rig with a [[can]]");
  if (found.tcp)
    throw InputError(file.name(), "is a capture of Modbus/TCP, expected a rig with a [[modbus]]");
  if (found.udp) throw InputError(file.name(), "is a capture of UDP, expected a rig with a [[udp]]");
  throw InputError(file.name(), "is a capture without CAN, TCP or UDP, expected one of them");
}

}  // namespace

std::unique_ptr<BusLog> open_log(const std::filesystem::path& path, const Buses& buses,
                                 const LogOptions& options) {
  LogFile file(path);
  if (format_of(file) == LogFormat::kCapture) return open_capture(std::move(file), buses, options);
  if (buses.can.empty()) throw InputError(file.name(), "is a CAN log, expected a rig with a [[can]]");
  return std::make_unique<CanLog>(std::move(file), buses.can, options);
}

}  // namespace rigsound::log
