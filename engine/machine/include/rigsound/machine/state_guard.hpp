// Nothing that reaches the layers is out of range or not a number.
#pragma once

#include "rigsound/machine/machine_state.hpp"

namespace rigsound {

/// `state` with every field inside its documented range; a NaN becomes the value that means "absent".
/// Thread: RT.
MachineState guarded(const MachineState& state) noexcept;

}  // namespace rigsound
