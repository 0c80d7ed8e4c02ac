// One read of a table through libmodbus.
#pragma once

#include <modbus.h>

#include "modbus/poll_plan.hpp"
#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {

/// False: errno says why not, an exception of the device included.
bool read_table(modbus_t* context, int unit, const PollRequest& request, Exchange& answer);

}  // namespace rigsound::modbus
