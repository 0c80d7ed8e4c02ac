#include "refused_values.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {
namespace {

/// What the last value was, or why there was none.
std::string last_text(const SignalBoard::Entry& entry) {
  return entry.last_refusal == Validity::kOutOfRange ? number_text(entry.last_refused)
                                                     : std::string(name(entry.last_refusal));
}

const char* plural(std::uint32_t count) { return count == 1 ? "" : "s"; }

}  // namespace

void print_refused_values(const config::Rig& rig, const SignalBoard& board) {
  for_each_signal(static_cast<int>(rig.engine.booms.size()), [&](SignalId id) {
    const SignalBoard::Entry& entry = board.entry(id);
    const Range range = info(id.signal).range();
    const std::string label = config::signal_label(rig, id);
    if (entry.refused > 0)
      fmt::print(stderr, "{}: {} value{} refused, last {}, expected {}\n", label, entry.refused,
                 plural(entry.refused), last_text(entry), range.text());
    if (entry.clamped > 0)
      fmt::print(stderr, "{}: {} value{} over the range taken as {} {}\n", label, entry.clamped,
                 plural(entry.clamped), number_text(range.max), range.unit);
  });
}

}  // namespace rigsound::tools
