// What the devices of a rig's Modbus links hold right now.
#pragma once

#include "rigsound/config/rig.hpp"

namespace rigsound::tools {

/// Reads every register of every link once and prints it; a value of two registers in all four word orders,
/// so that one can see which is right. A link on which the rig is the server is asked of the daemon that
/// serves it. Errors: DeviceError when a device does not answer. Thread: OFF.
void probe_modbus(const config::Rig& rig);

}  // namespace rigsound::tools
