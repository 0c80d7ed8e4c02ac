// Modbus/TCP as tcpdump recorded it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rigsound/log/log_file.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::log {

class CaptureFile;

struct TimedExchange {
  std::int64_t time_ns = 0;  ///< when the answer was seen, since the epoch
  modbus::Exchange exchange;
  HostPort server;  ///< who was asked
};

/// A port that a rig knows a server at.
struct ServerPort {
  int port = modbus::kPort;
  bool rtu_frames = false;  ///< RTU over TCP
};

struct CaptureCounts {
  std::uint64_t packets = 0;
  std::uint64_t exchanges = 0;
  std::uint64_t refused = 0;          ///< answered with an exception
  std::uint64_t unpaired = 0;         ///< answers without a request they fit
  std::uint64_t other_functions = 0;  ///< known to Modbus, no reading or writing of values
  std::uint64_t other = 0;            ///< packets, or pieces of streams, that are no Modbus/TCP
};

/// Takes streams apart into requests and answers, and pairs them. Functions 1-6, 15, 16, 22, 23. The server
/// of a stream is the side that was called (SYN), or whose port the rig knows, or has port 502, or the lower
/// port. Thread: OFF.
class ModbusCapture {
 public:
  /// Errors: InputError when it is no capture.
  explicit ModbusCapture(const LogFile& file, std::vector<ServerPort> servers = {});
  ~ModbusCapture();

  /// The next exchange, or false at the end. Errors: InputError when the file was cut off.
  bool next(TimedExchange& exchange);

  double share() const;  ///< of the file that has been read, 0...1
  const CaptureCounts& counts() const;

 private:
  class Streams;
  std::unique_ptr<CaptureFile> file_;
  std::unique_ptr<Streams> streams_;
};

}  // namespace rigsound::log
