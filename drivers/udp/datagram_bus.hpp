// A UDP port whose datagrams are readings, whatever is in them.
#pragma once

#include <sys/socket.h>

#include <array>
#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "bus/bus_base.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/network.hpp"

namespace rigsound::udp {

constexpr std::size_t kLongestDatagram = 8192;  ///< bytes; all signals of four booms take about 2000

/// Thread: the bus's own, but port() and counters().
class DatagramBus : public BusBase {
 public:
  struct Port {
    std::string host;
    int port = 0;
    std::vector<Network> allow;  ///< who may send; none: loopback
  };

  void step() override;
  std::vector<BusCounter> counters() const override;

  int port() const;  ///< bound, which matters when the options say 0; 0: not listening

 protected:
  struct Arrival {
    std::string_view bytes;
    std::string host;       ///< who sent it
    int port = 0;           ///< of the sender
    double realtime_s = 0;  ///< when the kernel got it, seconds since 1970; 0: it did not say
    double time_s = 0;      ///< the same in monotonic_s()
  };

  DatagramBus(std::string name, std::vector<SignalId> signals, Port port, BusListener& listener);

  virtual void take(const Arrival& arrival) = 0;  ///< from who may send, whole
  /// Called at the end of each round; the longest the next may wait, s.
  virtual double after_round() { return kLongestWait_s; }

  void deliver(const Reading& reading) { readings_.push_back(reading); }  ///< at the end of the round
  static void count(std::atomic<std::uint64_t>& counter) { counter.fetch_add(1, std::memory_order_relaxed); }

  static constexpr double kLongestWait_s = kRound_ms * 1e-3;
  std::atomic<std::uint64_t> used_{0}, bad_{0}, late_{0};

 private:
  static constexpr std::size_t kBatch = 64;

  void listen();
  void receive();
  void sift(const mmsghdr& message, std::size_t slot, double realtime_s, double time_s);

  Port port_;
  FileDescriptor socket_;
  std::vector<std::array<char, kLongestDatagram>> bytes_;
  std::array<std::array<unsigned char, 128>, kBatch> control_{};
  std::array<sockaddr_storage, kBatch> peers_{};
  std::array<iovec, kBatch> parts_{};
  std::array<mmsghdr, kBatch> messages_{};
  std::vector<Reading> readings_;
  double wait_s_ = kLongestWait_s;
  std::atomic<std::uint64_t> seen_{0}, dropped_{0}, rejected_{0};
};

}  // namespace rigsound::udp
