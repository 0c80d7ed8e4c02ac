#include "modbus/table_reader.hpp"

#include <algorithm>
#include <vector>

namespace rigsound::modbus {

bool read_table(modbus_t* c, int unit, const PollRequest& request, Exchange& answer) {
  answer = {unit, request.table, false, request.address, {}};
  answer.values.resize(request.count);
  const bool bits = holds_bits(request.table);
  std::vector<std::uint8_t> bit_values(bits ? answer.values.size() : 0);
  modbus_set_slave(c, unit);
  int got = -1;
  switch (request.table) {
    case Table::kHolding:
      got = modbus_read_registers(c, request.address, request.count, answer.values.data());
      break;
    case Table::kInput:
      got = modbus_read_input_registers(c, request.address, request.count, answer.values.data());
      break;
    case Table::kCoil:
      got = modbus_read_bits(c, request.address, request.count, bit_values.data());
      break;
    case Table::kDiscrete:
      got = modbus_read_input_bits(c, request.address, request.count, bit_values.data());
      break;
  }
  if (bits) std::copy(bit_values.begin(), bit_values.end(), answer.values.begin());
  return got == request.count;
}

}  // namespace rigsound::modbus
