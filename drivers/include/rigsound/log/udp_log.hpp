// Recorded datagrams of a UDP input.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/placed_entries.hpp"
#include "rigsound/log/udp_capture.hpp"
#include "rigsound/udp/datagram_reader.hpp"

namespace rigsound::log {

/// Datagrams go to the input of their port; when the capture has none to a port of the rig, and the rig has
/// one input, it gets all that look like JSON. Thread: OFF.
class UdpLog : public BusLog {
 public:
  /// Errors: InputError for a file that is no capture or holds nothing that these inputs can use.
  UdpLog(LogFile file, const std::vector<udp::UdpOptions>& inputs, const LogOptions& options);

  std::optional<double> next_s() override;
  bool read_until(double until_s, SignalBoard& board) override;
  double share() const override { return capture_->share(); }
  std::vector<LogNote> notes() const override;

 private:
  struct Input {
    udp::DatagramReader reader;
    udp::SequenceFilter sequence;
  };
  std::optional<udp::DatagramContent> read(const TimedDatagram& datagram, double time_s,
                                           std::string& problem);
  void survey(const std::vector<udp::UdpOptions>& inputs);

  LogFile file_;
  std::map<int, Input> inputs_;  // by port; 0: any
  std::optional<UdpCapture> capture_;
  PlacedEntries<UdpCapture, TimedDatagram> entries_;
  std::uint64_t seen_ = 0, used_ = 0, bad_ = 0, late_ = 0, unknown_ = 0;
  std::string first_unknown_;
};

}  // namespace rigsound::log
