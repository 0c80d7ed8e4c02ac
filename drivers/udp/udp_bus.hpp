// A UDP port that simulators send to.
#pragma once

#include <sys/socket.h>

#include <array>
#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "bus/bus_base.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/udp/datagram_reader.hpp"
#include "rigsound/udp/udp_bus.hpp"

namespace rigsound::udp {

constexpr std::size_t kLongestDatagram = 8192;  ///< bytes; all signals of four booms take about 2000

class UdpBus final : public BusBase {
 public:
  UdpBus(const UdpOptions& options, BusListener& listener, UdpTap* tap);
  void step() override;
  std::vector<BusCounter> counters() const override;

  int port() const;  ///< bound, which matters when the options say 0; 0: not listening

 private:
  static constexpr std::size_t kBatch = 64;

  void listen();
  void receive();
  double read_control(msghdr& header);
  void take(const mmsghdr& message, std::size_t slot, double realtime_s, double time_s);
  void take_text(std::string_view text, const std::string& from, const std::string& sender, double time_s);

  UdpOptions options_;
  UdpTap* tap_;
  DatagramReader reader_;
  std::map<std::string, SequenceFilter> sequences_;  // by sender
  FileDescriptor socket_;
  std::vector<std::array<char, kLongestDatagram>> bytes_;
  std::array<std::array<unsigned char, 128>, kBatch> control_{};
  std::array<sockaddr_storage, kBatch> peers_{};
  std::array<iovec, kBatch> parts_{};
  std::array<mmsghdr, kBatch> messages_{};
  std::vector<Reading> readings_;
  std::atomic<std::uint64_t> seen_{0}, used_{0}, bad_{0}, dropped_{0}, rejected_{0}, late_{0};
};

}  // namespace rigsound::udp
