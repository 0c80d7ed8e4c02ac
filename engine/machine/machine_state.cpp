#include "rigsound/machine/machine_state.hpp"

#include <cstring>

namespace rigsound {
namespace {

#define RIGSOUND_SAME_SIGNAL(id, member, ...) &&a.member == b.member
#define RIGSOUND_SAME_CONTROL(member, ...) &&a.controls.member == b.controls.member

bool same(const BoomState& a, const BoomState& b) noexcept {
  return a.by_hand == b.by_hand RIGSOUND_BOOM_SIGNALS(RIGSOUND_SAME_SIGNAL)
                          RIGSOUND_DRILL_CONTROLS(RIGSOUND_SAME_CONTROL);
}

}  // namespace

bool operator==(const MachineState& a, const MachineState& b) noexcept {
  // The same bytes are the same state, and mostly it is the same; other padding only costs the longer way.
  if (std::memcmp(&a, &b, sizeof a) == 0) return true;  // NOLINT(bugprone-suspicious-memory-comparison)
  bool equal = a.engine_rpm_slope == b.engine_rpm_slope && a.by_hand == b.by_hand &&
               a.output_gain == b.output_gain RIGSOUND_RIG_SIGNALS(RIGSOUND_SAME_SIGNAL);
  for (int i = 0; equal && i < kMaxBooms; ++i) equal = same(a.boom[i], b.boom[i]);
  return equal;
}

}  // namespace rigsound
