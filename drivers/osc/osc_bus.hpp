// A UDP port that speaks OSC.
#pragma once

#include <map>
#include <string>

#include "rigsound/osc/address_space.hpp"
#include "rigsound/osc/osc_bus.hpp"
#include "rigsound/osc/packet.hpp"
#include "udp/datagram_bus.hpp"

namespace rigsound::osc {

/// Messages of a bundle wait until its time; a time over 10 s ahead is that of a clock that is wrong, and
/// counts as at once, as one gone by does. At most 1024 wait.
class OscBus final : public udp::DatagramBus {
 public:
  OscBus(const OscOptions& options, BusListener& listener, ControlListener& controls);

 private:
  void take(const Arrival& arrival) override;
  double after_round() override;
  void obey(const Message& message, const std::string& from, double time_s);
  bool obey(const Target& target, const Said& said, double time_s);

  struct Waiting {
    Message message;
    std::string from;
  };
  AddressSpace addresses_;
  ControlListener& controls_;
  std::multimap<double, Waiting> waiting_;  // by monotonic_s()
};

}  // namespace rigsound::osc
