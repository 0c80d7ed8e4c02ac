// What one client is told whenever it changes.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "rigsound/config/json.hpp"

namespace rigsound::daemon {

/// {"every_s": 0.1...3600, "topics": [...]}: at most so often a line
/// {"event": "change", "uptime_s": S, "missed": N, "change": PATCH} with all that is other than in the line
/// before, as JSON merge patch (RFC 7396) of the status. In there `signals`, `buses` and `booms` are objects
/// by name, and what grows with every block is left out. The first line tells everything. Thread: CT.
class Subscription {
 public:
  /// Errors: Refused.
  explicit Subscription(const Json& request);

  double every_s() const { return every_s_; }
  const std::set<std::string>& topics() const { return topics_; }

  bool due(double now_s) const { return now_s >= next_s_; }
  /// The line that is due, with its newline; empty when nothing has changed. `status`: status_json().
  std::string line(const Json& status, double now_s);
  /// The line that is due finds its client busy with an older one: the next one covers both.
  void miss(double now_s);

 private:
  double every_s_ = 0.2, next_s_ = 0;
  std::set<std::string> topics_;
  std::uint64_t missed_ = 0;  // since the last line
  Json told_ = Json::object();
};

}  // namespace rigsound::daemon
