// Packets of a pcap or pcapng file. (libpcap reads no capture of several link types, and tells no interface.)
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "rigsound/log/log_file.hpp"

namespace rigsound::log {

/// LINKTYPE_RAW: what a file calls DLT_RAW.
constexpr std::uint32_t kRawIp = 101;

struct CapturedPacket {
  std::int64_t time_ns = 0;  ///< since the epoch
  int link_type = 0;         ///< a DLT_ value of libpcap
  std::string interface;     ///< as pcapng names it; empty: not named
  std::vector<std::uint8_t> bytes;
};

/// Whether the bytes are how a pcap or a pcapng begins.
bool begins_capture(const std::string& start);

/// pcap in both byte orders, with micro- and nanoseconds; pcapng with any number of sections and interfaces.
/// Thread: OFF.
class CaptureFile {
 public:
  /// Errors: InputError when it is no capture.
  explicit CaptureFile(const LogFile& file);

  /// The next packet, or false at the end. Errors: InputError when the file was cut off or is damaged.
  bool next(CapturedPacket& packet);

  double share() const {
    return share_of(bytes_ - left_, bytes_);
  }  ///< of the file that has been read, 0...1

 private:
  struct Interface {
    int link_type = 0;
    std::string name;
    std::uint64_t ticks_per_s = 1'000'000;
    std::int64_t offset_s = 0;
  };
  /// A block of pcapng without its lengths.
  struct Block {
    std::uint32_t type = 0;
    std::vector<std::uint8_t> body;
  };

  bool read(std::vector<std::uint8_t>& bytes, std::size_t size);  // false at the end of the file
  [[noreturn]] void fail(const std::string& what) const;
  std::uint32_t word16(const std::vector<std::uint8_t>& bytes, std::size_t at) const;
  std::uint32_t word32(const std::vector<std::uint8_t>& bytes, std::size_t at) const;
  void read_pcap_header(const std::vector<std::uint8_t>& start);
  bool next_pcap(CapturedPacket& packet);
  bool next_block(Block& block);
  bool next_pcapng(CapturedPacket& packet);
  void add_interface(const std::vector<std::uint8_t>& body);
  void set_option(std::uint32_t code, const std::vector<std::uint8_t>& body, std::size_t at, std::size_t size,
                  Interface& interface) const;
  bool take_packet(const Block& block, CapturedPacket& packet);

  std::string name_;
  std::ifstream in_;
  std::uintmax_t bytes_, left_;  // of the file, and not yet read
  bool pcapng_ = false, big_endian_ = false;
  std::vector<Interface> interfaces_;  // of a pcap: just one
  std::int64_t last_ns_ = 0;
};

}  // namespace rigsound::log
