// A click bank with the paper's six controls worked into it.
#pragma once

#include "rigsound/click_bank.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound {

/// `bank` as it is heard under `controls`, for neutral ones: rate, level and scatter exactly; attack and
/// decay as the engine reshapes each click, with the clicks' mean energy moved into B. Throws InvalidField
/// when nothing that can be played is left. Thread: OFF.
ClickBank refined_bank(const ClickBank& bank, const DrillControls& controls);

}  // namespace rigsound
