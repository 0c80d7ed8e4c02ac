// What a rig's OSC is for.
#pragma once

#include <string>
#include <vector>

#include "rigsound/machine/fields.hpp"
#include "rigsound/socket/network.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::osc {

struct OscOptions {
  std::string address;         ///< HOST:PORT or [V6]:PORT to listen at; empty: nothing comes in
  std::string host;            ///< taken from `address`
  int port = 0;                ///< taken from `address`
  std::vector<Network> allow;  ///< who may send; none: loopback
  std::vector<udp::NameRoute> routes;
  std::vector<std::string> booms;    ///< names, for the controls
  std::vector<std::string> targets;  ///< HOST:PORT in digits, where the status goes; none: nowhere
  double every_s = 0.1;              ///< between two of those
};

/// Everything but the lists.
template <class Archive>
void fields(Archive& a, OscOptions& o) {
  a("address", o.address);
  a("every_s", o.every_s, Range{0.1, 60, "s"});
}

}  // namespace rigsound::osc
