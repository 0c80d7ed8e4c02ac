#include "modbus/rtu_frame.hpp"

namespace rigsound::modbus {
namespace {

constexpr std::size_t kLongestFrame = 256;

/// A frame of `fixed` bytes of PDU whose byte `count_at` counts those that follow.
std::size_t counted(std::size_t fixed, std::size_t count_at, const std::uint8_t* bytes, std::size_t size) {
  const std::size_t frame = size > count_at ? kRtuEnds + fixed + bytes[count_at] : 0;
  return frame <= kLongestFrame ? frame : kLongestFrame + 1;
}

std::optional<std::size_t> request_size(const std::uint8_t* bytes, std::size_t size) {
  switch (bytes[1]) {
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
      return kRtuEnds + 5;
    case 15:
    case 16:
      return counted(6, 6, bytes, size);
    case 22:
      return kRtuEnds + 7;
    case 23:
      return counted(10, 10, bytes, size);
    default:
      return std::nullopt;
  }
}

std::optional<std::size_t> answer_size(const std::uint8_t* bytes, std::size_t size) {
  if ((bytes[1] & 0x80) != 0) return kRtuEnds + 2;
  switch (bytes[1]) {
    case 1:
    case 2:
    case 3:
    case 4:
    case 23:
      return counted(2, 2, bytes, size);
    case 5:
    case 6:
    case 15:
    case 16:
      return kRtuEnds + 5;
    case 22:
      return kRtuEnds + 7;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::uint16_t rtu_checksum(const std::uint8_t* bytes, std::size_t size) {
  unsigned crc = 0xFFFF;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xA001U : crc >> 1;
  }
  return static_cast<std::uint16_t>(crc);
}

bool rtu_checksum_holds(const std::uint8_t* bytes, std::size_t size) {
  if (size <= kRtuEnds) return false;
  return rtu_checksum(bytes, size - 2) == (bytes[size - 2] | bytes[size - 1] << 8);
}

std::optional<std::size_t> rtu_frame_size(RtuSide side, const std::uint8_t* bytes, std::size_t size) {
  if (size < 2) return 0;
  const auto frame = side == RtuSide::kRequest ? request_size(bytes, size) : answer_size(bytes, size);
  return frame && *frame > kLongestFrame ? std::nullopt : frame;
}

}  // namespace rigsound::modbus
