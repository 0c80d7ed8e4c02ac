// A Modbus connection of a rig: as client it asks a PLC, as server a simulator writes to it; TCP or RTU.
#pragma once

#include <memory>

#include "rigsound/bus/bus.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

using ModbusTap = BusTap<Exchange>;  ///< every agreed transaction

/// Readings carry the time of the answer. Errors: DeviceError for options that libmodbus does not take.
/// Thread: OFF.
std::unique_ptr<Bus> make_bus(const ModbusOptions& options, BusListener& listener, ModbusTap* tap = nullptr);

}  // namespace rigsound::modbus
