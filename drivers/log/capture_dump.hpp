// A pcap of IP packets that we make up: what was said, not how it travelled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rigsound::log {

constexpr int kMadeUpClientPort = 49152;

/// Raw IP, nanoseconds. Thread: one at a time. Errors: DeviceError.
class CaptureDump {
 public:
  explicit CaptureDump(const std::filesystem::path& file);
  ~CaptureDump();

  void write(std::int64_t time_ns, const std::vector<std::uint8_t>& packet);
  void flush();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// IPv4 and TCP headers around `frame`, between two ports of 127.0.0.1, checksums included.
std::vector<std::uint8_t> tcp_packet(const std::vector<std::uint8_t>& frame, int from_port, int to_port,
                                     std::uint32_t sequence, std::uint32_t acknowledged);

/// The same with UDP; `text`: at most 65507 bytes.
std::vector<std::uint8_t> udp_packet(const std::string& text, int from_port, int to_port);

}  // namespace rigsound::log
