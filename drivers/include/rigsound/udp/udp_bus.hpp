// Datagrams of a simulator: one JSON object each, the names of the rig's signals and their values.
#pragma once

#include <memory>
#include <string>

#include "rigsound/bus/bus.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::udp {

struct Datagram {
  std::string text;
  double realtime_s = 0;  ///< when the kernel got it, seconds since 1970; 0: it did not say
};

using UdpTap = BusTap<Datagram>;  ///< datagrams of those who may send

/// Listens; a port that is taken is tried again after pauses. Thread: OFF.
std::unique_ptr<Bus> make_bus(const UdpOptions& options, BusListener& listener, UdpTap* tap = nullptr);

}  // namespace rigsound::udp
