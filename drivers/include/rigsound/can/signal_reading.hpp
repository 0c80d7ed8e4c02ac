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

/// kJ1939: raw values that J1939-71 sets apart for errors (top byte 0xFE) and for "not available" (0xFF) are
/// none.
enum class RawValues : std::uint8_t { kAll, kJ1939 };

/// Nothing when a selector says that the signal is not in this frame. A signal that does not fit into the
/// frame is kNotAvailable. Thread: any.
std::optional<Decoded> read_signal(const SignalLayout& layout, RawValues raw_values, const Frame& frame);

/// True when the frame carries the message. Remote and error frames carry none.
bool matches(const MessageMatch& match, const Frame& frame);

/// Parameter group number of a 29 bit identifier: the destination of a PDU1 message is no part of it.
std::uint32_t pgn(std::uint32_t id);

}  // namespace rigsound::can
