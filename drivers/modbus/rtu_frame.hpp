// Modbus RTU frames in a stream that has no pauses to tell them apart: RTU over TCP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rigsound::modbus {

constexpr std::size_t kRtuEnds = 3;  ///< bytes around the PDU: unit, checksum

/// CRC-16 of the Modbus serial line specification, as it stands in a frame: low byte first.
std::uint16_t rtu_checksum(const std::uint8_t* bytes, std::size_t size);

/// Whether a frame of `size` bytes, unit and checksum included, ends with its checksum.
bool rtu_checksum_holds(const std::uint8_t* bytes, std::size_t size);

enum class RtuSide : std::uint8_t { kRequest, kAnswer };

/// Bytes of the frame that begins here, unit and checksum included, as its function and its counts tell; 0
/// while too few bytes are there; nothing for a function that is not known. At most 256.
std::optional<std::size_t> rtu_frame_size(RtuSide side, const std::uint8_t* bytes, std::size_t size);

}  // namespace rigsound::modbus
