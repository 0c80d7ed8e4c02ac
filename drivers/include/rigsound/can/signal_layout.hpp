// Where a signal lies in a frame and what its bits mean. Knows no DBC text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/machine/safety.hpp"

namespace rigsound::can {

enum class ByteOrder : std::uint8_t { kIntel, kMotorola };
enum class ValueType : std::uint8_t { kUnsigned, kSigned, kFloat32, kFloat64 };

/// A field of 1...64 bits. Bit 8 B + b is bit b (0 = least significant) of byte B.
struct BitField {
  int start_bit = 0;  ///< Intel: the least significant bit; Motorola: the most significant bit
  int length = 1;     ///< bits
  ByteOrder order = ByteOrder::kIntel;
};

/// One condition of a multiplexed signal: it is there only while the field holds one of these ranges.
struct Selector {
  BitField field;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;  ///< inclusive
};

/// A raw value that the signal map gives a meaning of its own; it overrules what J1939 sets apart.
struct RawCode {
  std::uint64_t raw = 0;
  Validity meaning = Validity::kValid;  ///< kValid, kErrorValue or kNotAvailable
};

struct SignalLayout {
  BitField field;
  ValueType type = ValueType::kUnsigned;
  double scale = 1, offset = 0;     ///< value = raw * scale + offset
  std::vector<Selector> selectors;  ///< all must hold; empty: always there
  std::vector<RawCode> codes;
};

/// Which frames carry a message.
struct MessageMatch {
  std::uint32_t id = 0;  ///< 11 or 29 bits, no flags
  bool extended = false;
  bool j1939 = false;  ///< match by PGN: priority, and for PF < 240 the destination, do not count
  std::optional<std::uint8_t> source;  ///< j1939 only: this source address and no other
};

}  // namespace rigsound::can
