// What a bus of a rig is told, to compare.
#pragma once

#include <string>

#include "rigsound/can/can_options.hpp"
#include "rigsound/modbus/modbus_bus.hpp"
#include "rigsound/osc/osc_options.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::config {

/// Everything that decides what the bus does: two with the same text need not be told apart. Not for people.
/// Thread: OFF.
std::string bus_text(const can::CanOptions& bus);
std::string bus_text(const modbus::Line& line);
std::string bus_text(const udp::UdpOptions& input);
std::string bus_text(const osc::OscOptions& osc);  ///< of its input

}  // namespace rigsound::config
