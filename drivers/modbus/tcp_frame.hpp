// Modbus TCP frames in a stream.
#pragma once

#include <modbus.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rigsound::modbus {

constexpr std::size_t kMbap = 7;  ///< bytes before the PDU: transaction 2, protocol 2, length 2, unit 1

/// Bytes of the frame that begins here; 0 while too few bytes are there; nothing for what is no Modbus.
inline std::optional<std::size_t> tcp_frame_size(const std::uint8_t* bytes, std::size_t size) {
  if (size < kMbap) return 0;
  const std::size_t length = bytes[4] << 8 | bytes[5];  // of unit and PDU
  const bool modbus = bytes[2] == 0 && bytes[3] == 0 && length >= 2 && length <= MODBUS_MAX_PDU_LENGTH + 1;
  return modbus ? std::optional<std::size_t>(kMbap - 1 + length) : std::nullopt;
}

}  // namespace rigsound::modbus
