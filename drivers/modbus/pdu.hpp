// The request that reads or writes an exchange, and the answer to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {

/// Function code and data. Reads use 1-4, writes 15 and 16. Input registers and discrete inputs cannot be
/// written: their exchanges must be reads.
std::vector<std::uint8_t> request_pdu(const Exchange& exchange);
std::vector<std::uint8_t> answer_pdu(const Exchange& exchange);

/// The values of an answer of `size` bytes to a read, as many as `exchange` has places for: bits or registers
/// after the byte count. False when it is none.
bool take_read(const std::uint8_t* pdu, std::size_t size, Exchange& exchange);

}  // namespace rigsound::modbus
