// Writes the exchanges of a Modbus bus as a capture that tcpdump, Wireshark and we can read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "rigsound/modbus/exchange.hpp"

namespace rigsound::log {

class CaptureDump;

/// Request and answer of each exchange as two TCP packets between 127.0.0.1:49152 and 127.0.0.1:502: what was
/// said, not how it travelled (a serial line looks the same). Raw IP, nanoseconds. Exchanges hold at most
/// what one request can. Thread: one at a time. Errors: DeviceError.
class ModbusCaptureWriter {
 public:
  explicit ModbusCaptureWriter(const std::filesystem::path& file);
  ~ModbusCaptureWriter();

  void write(std::int64_t time_ns, const modbus::Exchange& exchange);
  void flush();

 private:
  /// One direction of the connection.
  struct Side {
    int port = 0;
    std::uint32_t sequence = 1;
  };
  void packet(std::int64_t time_ns, Side& from, const Side& to, const std::vector<std::uint8_t>& pdu,
              int unit);

  std::unique_ptr<CaptureDump> file_;
  std::uint16_t transaction_ = 0;
  Side client_, server_;
};

}  // namespace rigsound::log
