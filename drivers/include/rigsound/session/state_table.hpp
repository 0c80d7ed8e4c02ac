// What `rigsound decode` printed: the machine's signals over time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"

namespace rigsound::session {

struct StateChange {
  double time_s;
  SignalId signal;  ///< its boom is a place in StateTable::booms
  double value;
};

struct StateTable {
  std::vector<std::string> booms;    ///< names; the first boom's is empty
  std::vector<StateChange> changes;  ///< times ascending

  bool holds(SignalId id) const;
};

/// Reads CSV time_s,signal,value; values are numbers or the signal's words. Errors: InputError with the line
/// for a missing column, an unknown signal, a value it cannot have, a time that falls back, more booms than
/// kMaxBooms; InputError when there is no row. Thread: OFF.
StateTable read_states(const std::filesystem::path& file);

}  // namespace rigsound::session
