// A transaction that both sides agreed on: what a device's table holds, or what was written to it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/machine/reading.hpp"
#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

struct Exchange {
  int unit = 255;
  Table table = Table::kHolding;
  bool written = false;               ///< false: read
  std::uint16_t address = 0;          ///< of the first value, 0-based
  std::vector<std::uint16_t> values;  ///< registers, or one bit each (0, 1)
};

/// Registers that a value takes; a bit takes one place.
int width(const RegisterRoute& route);

/// The value of a route whose first register (or bit) is `first`, `width(route)` of them. NaN for a raw value
/// that the route's table of values does not have.
double decode(const RegisterRoute& route, const std::uint16_t* first);

/// One reading for every route that lies wholly inside the exchange, true at `time_s`, added to `out`. What
/// the table of values does not have is kOutOfRange, with its raw value.
void readings(const Exchange& exchange, const std::vector<RegisterRoute>& routes, double time_s,
              std::vector<Reading>& out);

/// The number that the field's manuals give address 0 of a table: 40001, 30001, 1, 10001.
int manual_base(Table table);

/// `holding 0 = 40001`: the address on the wire and the one of the field's manuals.
std::string describe(Table table, std::uint16_t address);

}  // namespace rigsound::modbus
