// The status as OSC, to mixers and tablets.
#pragma once

#include <string>
#include <vector>

#include "rigsound/osc/osc_options.hpp"
#include "rigsound/osc/packet.hpp"
#include "rigsound/udp/udp_sender.hpp"
#include "snapshot.hpp"

namespace rigsound::daemon {

/// Bundles of at most 40 values: /rigsound/meters/..., /rigsound/muted, /rigsound/paused, /rigsound/SIGNAL
/// and /rigsound/BOOM/SIGNAL for what was ever said, /rigsound/BOOM/... for situation, impacts, levels and
/// controls.
std::vector<std::vector<osc::Value>> osc_bundles(const Snapshot& snapshot);

/// Never waits. Thread: CT.
class OscOutput {
 public:
  OscOutput() = default;  ///< to nobody
  /// Errors: DeviceError when a target is no address.
  explicit OscOutput(const osc::OscOptions& options);

  bool due(double now_s) const { return !targets_.empty() && now_s >= next_s_; }
  void send(const Snapshot& snapshot, double now_s);

 private:
  std::vector<udp::UdpSender> targets_;
  double every_s_ = 1, next_s_ = 0;
};

}  // namespace rigsound::daemon
