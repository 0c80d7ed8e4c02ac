// What every bus does alike: report to its listener, limit its warnings, pause between attempts.
#pragma once

#include <string>
#include <vector>

#include "backoff.hpp"
#include "rate_limited_log.hpp"
#include "rigsound/bus/bus.hpp"

namespace rigsound {

constexpr int kRound_ms = 200;  ///< the longest that a round of a bus waits

/// The targets of a bus's routes, in their order.
template <typename Route>
std::vector<SignalId> targets(const std::vector<Route>& routes) {
  std::vector<SignalId> ids;
  for (const Route& route : routes) ids.push_back(route.target);
  return ids;
}

/// Thread: the bus's own, but name() and signals().
class BusBase : public Bus {
 public:
  const std::string& name() const override { return name_; }
  const std::vector<SignalId>& signals() const override { return signals_; }

 protected:
  BusBase(std::string name, std::vector<SignalId> signals, BusListener& listener);

  void report(const std::vector<Reading>& readings);
  /// After a loss the signals are stale until their next value.
  void report_up();
  void report_down(const std::string& why);
  void report_all(Validity validity);           ///< one reading without a value for every signal
  void report_problem(const std::string& why);  ///< a notice, unless it is still the last problem
  /// A notice, at most one a minute of its kind.
  void warn(const std::string& kind, const std::string& text);

  /// Whether the device may be tried now; when not, waits up to 0.2 s of the pause.
  bool may_open() const;
  void opened();
  /// The device could not be opened: says why, and returns the pause until the next attempt, ms.
  std::int64_t open_failed(const std::string& why);
  void pause_before_reopening();

 private:
  std::string name_;
  std::vector<SignalId> signals_;
  BusListener& listener_;
  RateLimitedLog warnings_;
  Backoff backoff_;
  std::string problem_;  // reported last
  bool lost_ = false;    // down since it was up
};

}  // namespace rigsound
