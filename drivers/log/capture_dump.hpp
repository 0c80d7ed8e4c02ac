// A pcap of IP packets that we make up: what was said, not how it travelled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace rigsound::log {

/// An end of a connection over IPv4.
struct MadeUpEnd {
  std::uint32_t address = 0x7f000001;  ///< 127.0.0.1
  int port = 49152;
};

/// Raw IP, nanoseconds, the same bytes on every machine. Thread: one at a time. Errors: DeviceError.
class CaptureDump {
 public:
  explicit CaptureDump(const std::filesystem::path& file);

  void write(std::int64_t time_ns, const std::vector<std::uint8_t>& packet);
  void flush();

 private:
  void write(const std::vector<std::uint8_t>& bytes);

  std::string name_;
  std::ofstream out_;
};

/// IPv4 and TCP headers around `frame`, checksums included.
std::vector<std::uint8_t> tcp_packet(const std::vector<std::uint8_t>& frame, const MadeUpEnd& from,
                                     const MadeUpEnd& to, std::uint32_t sequence, std::uint32_t acknowledged);

/// The same with UDP; `text`: at most 65507 bytes.
std::vector<std::uint8_t> udp_packet(const std::string& text, const MadeUpEnd& from, const MadeUpEnd& to);

}  // namespace rigsound::log
