#include "modbus/pdu.hpp"

namespace rigsound::modbus {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint8_t function(const Exchange& e) {
  if (e.written) return e.table == Table::kCoil ? 15 : 16;
  switch (e.table) {
    case Table::kCoil:
      return 1;
    case Table::kDiscrete:
      return 2;
    case Table::kHolding:
      return 3;
    case Table::kInput:
      break;
  }
  return 4;
}

void put_word(Bytes& out, std::size_t word) {
  out.push_back(static_cast<std::uint8_t>(word >> 8 & 0xff));
  out.push_back(static_cast<std::uint8_t>(word & 0xff));
}

Bytes head(const Exchange& e) {
  Bytes out = {function(e)};
  put_word(out, e.address);
  put_word(out, e.values.size());
  return out;
}

std::size_t bytes_of_values(const Exchange& e) {
  return holds_bits(e.table) ? (e.values.size() + 7) / 8 : 2 * e.values.size();
}

void put_values(Bytes& out, const Exchange& e) {
  const std::size_t bytes = bytes_of_values(e);
  out.push_back(static_cast<std::uint8_t>(bytes));
  const std::size_t first = out.size();
  if (holds_bits(e.table)) out.resize(first + bytes);
  for (std::size_t i = 0; i < e.values.size(); ++i) {
    if (!holds_bits(e.table))
      put_word(out, e.values[i]);
    else if (e.values[i] != 0)
      out[first + i / 8] = static_cast<std::uint8_t>(out[first + i / 8] | 1 << i % 8);
  }
}

}  // namespace

Bytes request_pdu(const Exchange& e) {
  Bytes out = head(e);
  if (e.written) put_values(out, e);
  return out;
}

Bytes answer_pdu(const Exchange& e) {
  if (e.written) return head(e);
  Bytes out = {function(e)};
  put_values(out, e);
  return out;
}

bool take_read(const std::uint8_t* pdu, std::size_t size, Exchange& e) {
  const std::size_t bytes = bytes_of_values(e);
  if (size != 2 + bytes || pdu[1] != bytes) return false;
  const std::uint8_t* const data = pdu + 2;
  for (std::size_t i = 0; i < e.values.size(); ++i)
    e.values[i] = static_cast<std::uint16_t>(holds_bits(e.table) ? data[i / 8] >> (i % 8) & 1
                                                                 : data[2 * i] << 8 | data[2 * i + 1]);
  return true;
}

}  // namespace rigsound::modbus
