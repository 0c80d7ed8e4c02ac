// A UDP port that simulators send to.
#pragma once

#include <map>
#include <string>

#include "rigsound/udp/datagram_reader.hpp"
#include "rigsound/udp/udp_bus.hpp"
#include "udp/datagram_bus.hpp"

namespace rigsound::udp {

class UdpBus final : public DatagramBus {
 public:
  UdpBus(const UdpOptions& options, BusListener& listener, UdpTap* tap);

 private:
  void take(const Arrival& arrival) override;

  UdpTap* tap_;
  DatagramReader reader_;
  std::map<std::string, SequenceFilter> sequences_;  // by sender
};

}  // namespace rigsound::udp
