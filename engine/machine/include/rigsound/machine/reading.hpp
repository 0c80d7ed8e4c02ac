// What a bus says of one signal.
#pragma once

#include "rigsound/machine/signal.hpp"

namespace rigsound {

/// Plain data. Carries the message's own time (kernel stamp, answer time, log time) from the driver to where
/// it is used. Thread: any.
struct Reading {
  SignalId id;
  double value = 0;  ///< in the signal's unit; may be anything a bus can say, NaN included
  Validity validity = Validity::kValid;  ///< anything else: the bus said that there is no value
  double time_s = 0;                     ///< when it was true, seconds of the clock its reader counts in
};

}  // namespace rigsound
