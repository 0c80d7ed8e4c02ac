// The OSC addresses of a rig.
#pragma once

#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"
#include "rigsound/osc/osc_options.hpp"

namespace rigsound::osc {

/// Where an address leads: a signal, a control of a boom, or the mute.
struct Target {
  enum class Kind { kSignal, kControl, kMute };
  Kind kind = Kind::kMute;
  SignalId signal;                       ///< kSignal
  const ControlInfo* control = nullptr;  ///< kControl
  int boom = 0;                          ///< kControl
};

/// /rigsound/SIGNAL and /rigsound/BOOM/SIGNAL for what the rig's OSC takes, /rigsound/CONTROL (all booms) and
/// /rigsound/BOOM/CONTROL, /rigsound/mute. Thread: CT.
class AddressSpace {
 public:
  explicit AddressSpace(const OscOptions& options);

  /// All that `path` names, which may be a pattern of OSC (* ? [] {}, at most three *).
  std::vector<Target> find(const std::string& path) const;

 private:
  struct Entry {
    std::string path;
    Target target;
  };
  std::vector<Entry> entries_;
};

std::string path_of(const std::string& name);  ///< "/rigsound/boom2/rattling" of "boom2.rattling"

}  // namespace rigsound::osc
