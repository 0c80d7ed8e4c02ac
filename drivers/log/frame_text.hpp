// A frame as the log form of candump writes it: `0CF00400#F07D859B0FFFFF85`.
#pragma once

#include <cstdint>
#include <string_view>

#include "rigsound/can/frame.hpp"

namespace rigsound::log {

constexpr std::uint32_t kErrorFlag = 0x20000000;  ///< bit 29 of an identifier

/// 3 hexadecimal digits are an identifier of 11 bits, 8 one of 29 bits, or an error frame (bit 29).
bool parse_identifier(std::string_view digits, can::Frame& frame);

/// Classic, remote, FD and error frames. False for anything else; then `frame` holds rubbish.
bool parse_frame_text(std::string_view text, can::Frame& frame);

/// Whether it is a CAN XL frame.
bool is_xl_text(std::string_view text);

}  // namespace rigsound::log
