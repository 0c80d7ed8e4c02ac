// Stamps of a log as times that only go forward.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/log/log_note.hpp"

namespace rigsound::log {

/// Times of a log's entries in nanoseconds since its first one. A clock that was set while it wrote moves the
/// origin, and an entry whose stamp alone is wrong lies between its neighbours: no entry is lost, moved past
/// another, nor does any time pass that was not recorded. Stamps up to 50 ms behind are late entries of
/// another source and count as simultaneous. Thread: OFF.
class LogClock {
 public:
  /// `longest_gap_s`: pauses over it are left out, as `canplayer -s` does; nothing: all are kept.
  explicit LogClock(std::optional<double> longest_gap_s = std::nullopt);

  /// Entries in their order. `next_ns`: the stamp of the entry after, nothing at the end. `line`: of the
  /// file, 0 for none.
  std::int64_t place(std::int64_t stamp_ns, std::optional<std::int64_t> next_ns, int line);

  std::vector<LogNote> notes() const;  ///< one for each kind of thing that happened

 private:
  /// Things of a kind: how many, and the first.
  struct Events {
    std::uint64_t count = 0;
    int line = 0;
    double first_s = 0;
    void add(int at_line, double size_s);
  };
  std::int64_t gap_to(std::int64_t stamp_ns, std::optional<std::int64_t> next_ns, int line);

  std::optional<std::int64_t> longest_gap_ns_;
  std::optional<std::int64_t> last_stamp_ns_;
  std::int64_t now_ns_ = 0, usual_gap_ns_;
  Events forward_, backward_, late_, lone_, long_, skipped_;
};

}  // namespace rigsound::log
