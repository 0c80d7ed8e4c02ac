// A table of states as a source of states, block by block: what `rigsound decode` prints, or a person writes.
#pragma once

#include "rigsound/audio/block_loop.hpp"
#include "rigsound/session/state_table.hpp"

namespace rigsound::session {

/// A row acts from the first block on that begins at its time or later; half a microsecond later counts as at
/// it, since tables are printed in microseconds. Values stand as they are: no safety rule, and the diesel's
/// speed is not extrapolated. Ends with the last row. Thread: OFF.
class TableStates : public audio::StateSource {
 public:
  /// Errors: InputError, as read_states, or for a boom that the rig has not.
  TableStates(const std::filesystem::path& file, const EngineOptions& options);

  const MachineState* state_of(std::uint64_t number) override;

  double end_s() const { return table_.changes.back().time_s; }  ///< of the last row

 private:
  StateTable table_;
  double block_s_;
  std::size_t next_ = 0;
  MachineState state_;
};

}  // namespace rigsound::session
