// A request to a server, taken apart and checked before libmodbus sees it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

/// Exception codes of the Modbus application protocol, section 7.
enum class Refusal : std::uint8_t { kFunction = 1, kAddress = 2, kValue = 3, kUnit = 11 };

struct Range {
  std::uint16_t address = 0;
  int count = 0;
};

struct Request {
  Table table = Table::kHolding;
  std::optional<Range> read;
  std::optional<Range> write;
  std::vector<std::uint16_t> values;             ///< to be written, registers or one bit each
  std::uint16_t and_mask = 0xffff, or_mask = 0;  ///< function 22: value = old & and | or & ~and
  bool masked = false;
};

/// `pdu`: function code and data, `size` bytes in all. Functions 1-6, 15, 16, 22, 23; lengths, counts and
/// byte counts must be exactly those of the protocol. Returns why not, or nothing.
std::optional<Refusal> parse(const std::uint8_t* pdu, std::size_t size, Request& request);

}  // namespace rigsound::modbus
