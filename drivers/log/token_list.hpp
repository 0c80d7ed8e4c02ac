// The words of a line, and frames made of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "log/line_cursor.hpp"
#include "rigsound/can/frame.hpp"

namespace rigsound::log {

/// Words between blanks, at most 128. Asking for one that is not there gives an empty word.
class TokenList {
 public:
  explicit TokenList(std::string_view line) {
    constexpr std::size_t kMost = 128;  // 64 bytes and what stands around them
    LineCursor at(line);
    at.spaces();
    while (!at.at_end() && tokens_.size() < kMost) tokens_.push_back(at.token());
  }
  std::size_t size() const { return tokens_.size(); }
  std::string_view operator[](std::size_t i) const {
    return i < tokens_.size() ? tokens_[i] : std::string_view();
  }

 private:
  std::vector<std::string_view> tokens_;
};

/// A number of the base, 10 or 16, up to `max`.
inline std::optional<std::uint32_t> number_of(std::string_view digits, int base, std::uint32_t max) {
  std::uint64_t value = 0;
  if (digits.empty()) return std::nullopt;
  for (const char c : digits) {
    const int digit = hex_digit(c);
    if (digit < 0 || digit >= base) return std::nullopt;
    value = value * static_cast<unsigned>(base) + static_cast<unsigned>(digit);
    if (value > max) return std::nullopt;
  }
  return static_cast<std::uint32_t>(value);
}

/// Bytes of a CAN FD frame of this length code; a classic frame has at most 8.
inline int bytes_of_code(std::uint32_t code) {
  constexpr int kLong[] = {12, 16, 20, 24, 32, 48, 64};  // codes 9...15, ISO 11898-1
  return code <= 8 ? static_cast<int>(code) : kLong[code - 9];
}

/// `frame.size` bytes from word `first` on; false when one is missing or no byte.
inline bool take_bytes(const TokenList& tokens, std::size_t first, int base, can::Frame& frame) {
  for (std::size_t i = 0; i < frame.size; ++i) {
    const auto byte = number_of(tokens[first + i], base, 255);
    if (!byte) return false;
    frame.data[i] = static_cast<std::uint8_t>(*byte);
  }
  return true;
}

/// `can0` for channel 1: what Linux calls the first interface.
inline std::string interface_of_channel(std::uint32_t channel) {
  return "can" + std::to_string(channel > 0 ? channel - 1 : 0);
}

}  // namespace rigsound::log
