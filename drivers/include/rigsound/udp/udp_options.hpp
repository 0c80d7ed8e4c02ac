// What one UDP input of a rig is for.
#pragma once

#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"
#include "rigsound/socket/network.hpp"

namespace rigsound::udp {

/// One machine signal that datagrams may name.
struct NameRoute {
  SignalId target{};
  std::string name;   ///< as in the rig: "engine_rpm", "boom2.rattling"
  std::string alias;  ///< of the first boom's signals: the name with the boom before it; else empty
};

struct UdpOptions {
  std::string address = "127.0.0.1:1503";  ///< HOST:PORT or [V6]:PORT to listen at
  std::string host = "127.0.0.1";          ///< taken from `address`
  int port = 1503;                         ///< taken from `address`
  std::vector<Network> allow;              ///< who may send; none: loopback
  std::vector<NameRoute> routes;
};

/// Everything but the networks and the routes.
template <class Archive>
void fields(Archive& a, UdpOptions& o) {
  a("address", o.address);
}

}  // namespace rigsound::udp
