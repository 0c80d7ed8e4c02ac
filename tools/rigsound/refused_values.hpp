// What verbs say of values that no signal could take.
#pragma once

#include "rigsound/config/rig.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::tools {

/// One line a signal to stderr, such as `feed_pressure_bar: 12 values refused, last 410, expected 0...300
/// bar`.
void print_refused_values(const config::Rig& rig, const SignalBoard& board);

}  // namespace rigsound::tools
