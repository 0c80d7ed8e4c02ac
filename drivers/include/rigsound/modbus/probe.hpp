// What a device holds where a rig looks for its signals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

struct Probed {
  std::vector<std::uint16_t> words;  ///< registers, or one bit; empty: it cannot be read
  std::string problem;               ///< why not
};

/// Reads each route once, by itself, in the order of the routes. Errors: DeviceError when the device cannot
/// be reached. Thread: OFF.
std::vector<Probed> probe(const ModbusOptions& options);

}  // namespace rigsound::modbus
