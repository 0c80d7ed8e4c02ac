// The control socket's language: one JSON object a line in, one out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reload_queue.hpp"
#include "rigsound/machine/signal.hpp"
#include "snapshot.hpp"
#include "subscription.hpp"

namespace rigsound::daemon {

/// What the commands may do.
class DaemonControl {
 public:
  virtual ~DaemonControl() = default;
  virtual Snapshot snapshot() const = 0;
  virtual Snapshot scrape() = 0;           ///< its levels are those since the last scrape
  virtual std::uint64_t ask_reload() = 0;  ///< its number
  virtual const ReloadResult* reload_result(std::uint64_t number) const = 0;  ///< null: it is not over
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

/// What a client has asked for that goes on.
struct ClientState {
  std::optional<Subscription> subscription;
  std::optional<std::uint64_t> reload;  ///< the one whose result is awaited
};

/// One request, PROTOCOL.md, as one line with a newline; empty: late_answer() has it. Never throws. Thread:
/// CT.
std::string answer(const std::string& request, DaemonControl& daemon, ClientState& client);

/// To a reload; empty: it is not over, or none was asked for. Thread: CT.
std::string late_answer(const DaemonControl& daemon, ClientState& client);

}  // namespace rigsound::daemon
