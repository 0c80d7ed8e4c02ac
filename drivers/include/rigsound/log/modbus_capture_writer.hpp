// Writes the exchanges of a Modbus bus as a capture that tcpdump, Wireshark and we can read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "rigsound/modbus/exchange.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::log {

class CaptureDump;

/// Request and answer of each exchange as two TCP packets between 127.0.0.1:49152 and the server: what was
/// said, not how it travelled. A serial line, and a server named by a word or by IPv6, is 127.0.0.1 there.
/// Raw IP, nanoseconds. Exchanges hold at most what one request can. Thread: one at a time. Errors:
/// DeviceError.
class ModbusCaptureWriter {
 public:
  explicit ModbusCaptureWriter(const std::filesystem::path& file);
  ~ModbusCaptureWriter();

  /// `server`: who was asked; port 0 of a serial line.
  void write(std::int64_t time_ns, const HostPort& server, const modbus::Exchange& exchange);
  void flush();

 private:
  /// Sequence numbers of a connection.
  struct Connection {
    std::uint32_t to_server = 1, to_client = 1;
  };

  std::unique_ptr<CaptureDump> file_;
  std::uint16_t transaction_ = 0;
  std::map<std::pair<std::uint32_t, int>, Connection> connections_;  // by address and port
};

}  // namespace rigsound::log
