// What a signal map says of a signal, held against what the machine's signal is.
#pragma once

#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"

namespace rigsound::config {

/// A signal of a DBC that a rig uses.
struct MappedSignal {
  SignalId target;
  std::string where;             ///< `FILE:LINE: KEY` of the rig
  std::string name, unit;        ///< of the DBC
  double min = 0, max = 0;       ///< as the DBC says, in its unit; both 0: it says nothing
  double scale = 1, offset = 0;  ///< of the rig, on top of the DBC's
};

/// A number of DBC signals is understood by its unit: "%" for a share of 1. Then the scale that goes with it,
/// else 1.
double scale_of_unit(Signal target, const std::string& unit);

/// One line for each that is probably a mistake: `WHERE: what is odd, what was meant?`. Units that do not go
/// together, two signals that are swapped, a range that is not inside the machine signal's.
std::vector<std::string> doubts(const std::vector<MappedSignal>& signals);

}  // namespace rigsound::config
