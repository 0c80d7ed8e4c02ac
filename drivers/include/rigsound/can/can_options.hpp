// What one CAN bus of a rig is for.
#pragma once

#include <string>
#include <vector>

#include "rigsound/can/signal_layout.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::can {

/// One machine signal that this bus delivers.
struct SignalRoute {
  SignalId target{};
  std::string name;  ///< MESSAGE.SIGNAL, for people
  MessageMatch match;
  SignalLayout layout;
  double cycle_s = 0;  ///< time between two messages as the DBC promises it; 0: not known
};

struct CanOptions {
  std::string interface;  ///< as in `ip link`, e.g. can0
  bool fd = false;        ///< take CAN FD frames too
  std::vector<SignalRoute> routes;
};

/// Everything but the routes.
template <class Archive>
void fields(Archive& a, CanOptions& o) {
  a("interface", o.interface);
  a("fd", o.fd);
}

}  // namespace rigsound::can
