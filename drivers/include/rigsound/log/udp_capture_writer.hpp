// Writes the datagrams of a UDP input as a capture that tcpdump, Wireshark and we can read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace rigsound::log {

class CaptureDump;

/// Each as a packet from 127.0.0.1:49152 to the rig's port at 127.0.0.1. Thread: one at a time. Errors:
/// DeviceError.
class UdpCaptureWriter {
 public:
  explicit UdpCaptureWriter(const std::filesystem::path& file);
  ~UdpCaptureWriter();

  void write(std::int64_t time_ns, int port, const std::string& text);
  void flush();

 private:
  std::unique_ptr<CaptureDump> file_;
};

}  // namespace rigsound::log
