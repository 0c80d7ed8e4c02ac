#include "modbus/request.hpp"

namespace rigsound::modbus {
namespace {

using RawBytes = const std::uint8_t*;

std::uint16_t word(RawBytes at) { return static_cast<std::uint16_t>(at[0] << 8 | at[1]); }

bool fits(const Range& range, int most) {
  return range.count >= 1 && range.count <= most && range.address + range.count <= 0x10000;
}

std::optional<Refusal> refuse_unless(bool good) {
  return good ? std::nullopt : std::optional<Refusal>(Refusal::kValue);
}

std::optional<Refusal> parse_read(RawBytes pdu, std::size_t size, Table table, int most, Request& r) {
  if (size != 5) return Refusal::kValue;
  r.table = table;
  r.read = Range{word(pdu + 1), word(pdu + 3)};
  return refuse_unless(fits(*r.read, most));
}

std::optional<Refusal> parse_single(RawBytes pdu, std::size_t size, Table table, Request& r) {
  if (size != 5) return Refusal::kValue;
  r.table = table;
  r.write = Range{word(pdu + 1), 1};
  const std::uint16_t value = word(pdu + 3);
  if (table == Table::kHolding) {
    r.values = {value};
    return std::nullopt;
  }
  r.values = {static_cast<std::uint16_t>(value == 0xff00)};
  return refuse_unless(value == 0xff00 || value == 0);
}

std::optional<Refusal> parse_coils(RawBytes pdu, std::size_t size, Request& r) {
  if (size < 6) return Refusal::kValue;
  r.table = Table::kCoil;
  r.write = Range{word(pdu + 1), word(pdu + 3)};
  const std::size_t bytes = (r.write->count + 7) / 8;
  if (!fits(*r.write, 1968) || pdu[5] != bytes || size != 6 + bytes) return Refusal::kValue;
  for (int i = 0; i < r.write->count; ++i)
    r.values.push_back(static_cast<std::uint16_t>(pdu[6 + i / 8] >> (i % 8) & 1));
  return std::nullopt;
}

// `head` bytes up to and with the byte count, then the registers.
std::optional<Refusal> parse_registers(RawBytes pdu, std::size_t size, std::size_t head, int most,
                                       Request& r) {
  if (size < head) return Refusal::kValue;
  r.table = Table::kHolding;
  r.write = Range{word(pdu + head - 5), word(pdu + head - 3)};
  const std::size_t bytes = 2 * r.write->count;
  if (!fits(*r.write, most) || pdu[head - 1] != bytes || size != head + bytes) return Refusal::kValue;
  for (std::size_t i = 0; i < bytes; i += 2) r.values.push_back(word(pdu + head + i));
  return std::nullopt;
}

std::optional<Refusal> parse_mask(RawBytes pdu, std::size_t size, Request& r) {
  if (size != 7) return Refusal::kValue;
  r.table = Table::kHolding;
  r.write = Range{word(pdu + 1), 1};
  r.masked = true;
  r.and_mask = word(pdu + 3);
  r.or_mask = word(pdu + 5);
  return std::nullopt;
}

std::optional<Refusal> parse_read_write(RawBytes pdu, std::size_t size, Request& r) {
  if (size < 10) return Refusal::kValue;
  r.read = Range{word(pdu + 1), word(pdu + 3)};
  if (!fits(*r.read, 125)) return Refusal::kValue;
  return parse_registers(pdu, size, 10, 121, r);
}

}  // namespace

std::optional<Refusal> parse(RawBytes pdu, std::size_t size, Request& request) {
  request = {};
  if (size == 0) return Refusal::kFunction;
  switch (pdu[0]) {
    case 1:
      return parse_read(pdu, size, Table::kCoil, 2000, request);
    case 2:
      return parse_read(pdu, size, Table::kDiscrete, 2000, request);
    case 3:
      return parse_read(pdu, size, Table::kHolding, 125, request);
    case 4:
      return parse_read(pdu, size, Table::kInput, 125, request);
    case 5:
      return parse_single(pdu, size, Table::kCoil, request);
    case 6:
      return parse_single(pdu, size, Table::kHolding, request);
    case 15:
      return parse_coils(pdu, size, request);
    case 16:
      return parse_registers(pdu, size, 6, 123, request);
    case 22:
      return parse_mask(pdu, size, request);
    case 23:
      return parse_read_write(pdu, size, request);
    default:
      return Refusal::kFunction;
  }
}

}  // namespace rigsound::modbus
