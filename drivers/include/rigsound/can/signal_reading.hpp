// Bits of a frame into a value, or into the reason why there is none.
#pragma once

#include <cstdint>
#include <optional>

#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_layout.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::can {

/// Index of the last byte the field touches.
int last_byte(const BitField& field);

/// The bits of the field, or nothing when the frame is too short for it.
std::optional<std::uint64_t> extract(const BitField& field, const Frame& frame);

/// `validity` is kValid (with `value`), kErrorValue or kNotAvailable.
struct Decoded {
  Validity validity = Validity::kNotAvailable;
  double value = 0;
};

/// kJ1939: raw values of unsigned fields that J1939-71 sets apart are none, at every length:
///   2...7 bits    the last two: error, not available
///   8...11 bits   the last five: three for no value, error, not available
///   12 bits on    by the top byte: 0xFB...0xFD no value, 0xFE error, 0xFF not available
/// A field of one bit has no such value.
enum class RawValues : std::uint8_t { kAll, kJ1939 };

/// What J1939-71 says of a raw value: kValid, kErrorValue or kNotAvailable. `length`: bits, 1...64.
Validity j1939_meaning(int length, std::uint64_t raw);

/// Nothing when a selector says that the signal is not in this frame. A signal that does not fit into the
/// frame is kNotAvailable. Thread: any.
std::optional<Decoded> read_signal(const SignalLayout& layout, RawValues raw_values, const Frame& frame);

/// True when the frame carries the message. Remote and error frames carry none.
bool matches(const MessageMatch& match, const Frame& frame);

/// Parameter group number of a 29 bit identifier: the destination of a PDU1 message is no part of it.
std::uint32_t pgn(std::uint32_t id);

}  // namespace rigsound::can
