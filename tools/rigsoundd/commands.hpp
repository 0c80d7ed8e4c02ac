// The control socket's language: one JSON object a line in, one out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"
#include "snapshot.hpp"
#include "subscription.hpp"

namespace rigsound::daemon {

struct ReloadResult {
  std::string error;                     ///< empty: the new rig is in force
  std::vector<std::string> not_applied;  ///< keys that need a restart, with old and new value
};

/// What the commands may do.
class DaemonControl {
 public:
  virtual ~DaemonControl() = default;
  virtual Snapshot snapshot() const = 0;
  virtual Snapshot scrape() = 0;  ///< its levels are those since the last scrape
  virtual ReloadResult reload() = 0;
  virtual void set_muted(bool muted) = 0;
  virtual void reset_exposure() = 0;
  virtual std::vector<std::string> boom_names() const = 0;
  virtual DrillControls controls(int boom) const = 0;
  virtual void set_control(int boom, const ControlInfo& control, double value) = 0;  ///< one that it takes
  virtual std::vector<std::string> rock_names() const = 0;
  virtual bool holds(SignalId id) const = 0;
  virtual void hold(SignalId id, double value) = 0;  ///< a value that the signal takes
  virtual void release(SignalId id) = 0;
};

/// One request, PROTOCOL.md, as one line with a newline. `subscription`: the client's own. Never throws.
/// Thread: CT.
std::string answer(const std::string& request, DaemonControl& daemon,
                   std::optional<Subscription>& subscription);

}  // namespace rigsound::daemon
