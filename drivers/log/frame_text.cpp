#include "log/frame_text.hpp"

#include "log/line_cursor.hpp"

namespace rigsound::log {
namespace {

bool parse_data(LineCursor& at, can::Frame& frame, int most) {
  while (const auto byte = at.hex(2)) {
    if (frame.size == most) return false;
    frame.data[frame.size++] = static_cast<std::uint8_t>(*byte);
    at.eat('.');
  }
  return true;
}

bool parse_raw_dlc(LineCursor& at, can::Frame& frame) {
  if (!at.eat('_')) return true;
  const auto dlc = at.hex(1);
  if (!dlc || *dlc < 9 || frame.size != 8) return false;
  frame.raw_dlc = static_cast<std::uint8_t>(*dlc);
  return true;
}

bool parse_remote(LineCursor& at, can::Frame& frame) {
  frame.remote = true;
  if (is_digit(at.peek())) {
    const auto size = at.hex(1);
    if (*size > 8) return false;
    frame.size = static_cast<std::uint8_t>(*size);
  }
  return parse_raw_dlc(at, frame);
}

bool parse_fd(LineCursor& at, can::Frame& frame) {
  const auto flags = at.hex(1);
  if (!flags) return false;
  frame.fd = true;
  frame.bit_rate_switch = (*flags & 1U) != 0;
  frame.error_passive = (*flags & 2U) != 0;
  return parse_data(at, frame, can::kMaxData);
}

}  // namespace

bool parse_identifier(std::string_view digits, can::Frame& frame) {
  if (digits.size() != 3 && digits.size() != 8) return false;
  const auto id = LineCursor(digits).hex(digits.size());
  if (!id) return false;
  frame.extended = digits.size() == 8;
  if (!frame.extended) {
    frame.id = *id;
    return *id <= can::kMaxStandardId;
  }
  frame.error = (*id & kErrorFlag) != 0;
  if (frame.error) frame.extended = false;
  frame.id = *id & can::kMaxExtendedId;
  return (*id & ~(kErrorFlag | can::kMaxExtendedId)) == 0;
}

bool parse_frame_text(std::string_view text, can::Frame& frame) {
  const std::size_t hash = text.find('#');
  if (hash == std::string_view::npos || !parse_identifier(text.substr(0, hash), frame)) return false;
  LineCursor at(text.substr(hash + 1));
  bool good = false;
  if (at.eat('#'))
    good = parse_fd(at, frame);
  else if (at.eat('R') || at.eat('r'))
    good = parse_remote(at, frame);
  else
    good = parse_data(at, frame, 8) && parse_raw_dlc(at, frame);
  return good && at.at_end();
}

bool is_xl_text(std::string_view text) {
  LineCursor at(text);
  return at.hex(5) && at.eat('#') && at.hex(2) && at.eat(':') && at.hex(2) && at.eat(':') && at.hex(8) &&
         at.eat('#');
}

}  // namespace rigsound::log
