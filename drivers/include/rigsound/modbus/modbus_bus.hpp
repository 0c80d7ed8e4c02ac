// A Modbus connection of a rig: as client it asks a PLC, as server a simulator writes to it; TCP or RTU.
#pragma once

#include <memory>
#include <vector>

#include "rigsound/bus/bus.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

using ModbusTap = BusTap<Exchange>;  ///< every agreed transaction

/// The sections of a rig that share one serial line, or one connection to a gateway: one master asks their
/// units in turn. A server is a line of its own.
using Line = std::vector<ModbusOptions>;

/// In the order of the sections. Thread: OFF.
std::vector<Line> lines(const std::vector<ModbusOptions>& sections);

/// `line`: not empty. Readings carry the time of the answer. Errors: DeviceError for options that libmodbus
/// does not take. Thread: OFF.
std::unique_ptr<Bus> make_bus(const Line& line, BusListener& listener, ModbusTap* tap = nullptr);

}  // namespace rigsound::modbus
