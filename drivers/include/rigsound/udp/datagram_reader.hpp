// One datagram as readings.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/machine/reading.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::udp {

/// `{"engine_rpm": 1500, "rattling": "open", "boom2": {"percussion": true}, "seq": 17}`: names may have the
/// boom before a dot or be grouped by boom; a value is a number, a word of the signal, true or false for 1 or
/// 0, or null when there is none. `seq` is optional. A datagram counts whole or not at all.
struct DatagramContent {
  std::vector<Reading> readings;
  std::optional<std::int64_t> sequence;  ///< `seq`
  std::string unknown;                   ///< the first name that is none of the rig's; empty: all are
  std::uint64_t unknown_count = 0;
};

/// Thread: CT, one at a time.
class DatagramReader {
 public:
  explicit DatagramReader(const std::vector<NameRoute>& routes);

  /// Nothing when it is no such object; then `problem` says why. Readings are true at `time_s`.
  std::optional<DatagramContent> read(std::string_view text, double time_s, std::string& problem) const;

 private:
  std::map<std::string, SignalId, std::less<>> names_;
};

/// Numbers that only grow, so that a datagram the network delivered late is told from a newer one. A sender
/// may begin anew: a number far behind, or one after a pause, is a new beginning.
class SequenceFilter {
 public:
  /// Whether a datagram with this number still counts.
  bool passes(std::int64_t sequence, double time_s);

 private:
  std::optional<std::int64_t> last_;
  double last_s_ = 0;
};

}  // namespace rigsound::udp
