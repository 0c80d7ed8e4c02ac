// The changes of the state that a recorded bus leads to.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "rigsound/log/bus_log.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::log {

struct Change {
  double time_s = 0;  ///< since the first entry of the log
  SignalId signal{};
  double value = 0;  ///< after the safety rule, in the signal's unit
};

/// Plays the whole log and reports every change of every signal in `watched`: the first valid value, then
/// whenever the value differs. Safety rules act on the way; between frames that lie far apart their
/// fades are followed in steps of 10 ms. Returns what is known of the signals in the end. Errors: InputError.
/// Thread: OFF.
SignalBoard trace_changes(BusLog& log, const SafetyOptions& safety, const std::vector<SignalId>& watched,
                          const std::function<void(const Change&)>& report);

}  // namespace rigsound::log
