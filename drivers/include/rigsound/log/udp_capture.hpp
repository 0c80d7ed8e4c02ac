// Datagrams of a capture.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/log/log_file.hpp"

namespace rigsound::log {

class CaptureFile;

struct TimedDatagram {
  std::int64_t time_ns = 0;  ///< since the epoch
  int port = 0;              ///< it was sent to
  std::string text;
};

/// Thread: OFF.
class UdpCapture {
 public:
  /// `ports`: those that count; empty: all to which the capture has JSON objects. Errors: InputError when it
  /// is no capture.
  UdpCapture(const LogFile& file, std::vector<int> ports);
  ~UdpCapture();

  /// The next datagram, or false at the end. Errors: InputError when the file was cut off.
  bool next(TimedDatagram& datagram);

  double share() const;  ///< of the file that has been read, 0...1

 private:
  std::unique_ptr<CaptureFile> file_;
  std::vector<int> ports_;
};

}  // namespace rigsound::log
