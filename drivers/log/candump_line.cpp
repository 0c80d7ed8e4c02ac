#include <algorithm>
#include <cstdio>
#include <optional>

#include "rigsound/log/candump.hpp"

namespace rigsound::log {
namespace {

constexpr std::uint32_t kErrorFlag = 0x20000000;
constexpr std::uint32_t kExtendedMask = 0x1FFFFFFF, kStandardMask = 0x7FF;
constexpr std::int64_t kMaxSeconds = 9000000000;  // the year 2255; nanoseconds fit into 63 bits
constexpr std::size_t kMaxInterface = 15;         // IFNAMSIZ without its zero

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int hex_digit(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Eats a text from the left. Every function says whether it found what it wanted and eats only then.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  bool at_end() const { return text_.empty(); }
  char peek() const { return text_.empty() ? '\0' : text_.front(); }
  bool eat(char c) {
    if (peek() != c || text_.empty()) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool spaces() {
    const std::size_t before = text_.size();
    while (eat(' ') || eat('\t')) continue;
    return text_.size() < before;
  }
  std::string_view digits() {
    std::size_t n = 0;
    while (n < text_.size() && is_digit(text_[n])) ++n;
    return take(n);
  }
  std::string_view word() { return take(std::min(text_.find_first_of(" \t"), text_.size())); }
  std::optional<std::uint32_t> hex(std::size_t count) {
    if (text_.size() < count) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const int digit = hex_digit(text_[i]);
      if (digit < 0) return std::nullopt;
      value = value << 4 | static_cast<std::uint32_t>(digit);
    }
    take(count);
    return value;
  }

 private:
  std::string_view take(std::size_t n) {
    const std::string_view taken = text_.substr(0, n);
    text_.remove_prefix(n);
    return taken;
  }
  std::string_view text_;
};

std::optional<std::int64_t> whole_number(std::string_view digits, std::int64_t max) {
  if (digits.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    value = value * 10 + (c - '0');
    if (value > max) return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> parse_time(Cursor& at) {
  if (!at.eat('(')) return std::nullopt;
  const auto seconds = whole_number(at.digits(), kMaxSeconds);
  if (!seconds || !at.eat('.')) return std::nullopt;
  const std::string_view digits = at.digits();
  const auto fraction = whole_number(digits, 999999999);
  if (!fraction || (digits.size() != 6 && digits.size() != 9) || !at.eat(')')) return std::nullopt;
  return *seconds * 1000000000 + (digits.size() == 6 ? *fraction * 1000 : *fraction);
}

bool parse_data(Cursor& at, can::Frame& frame, int most) {
  while (const auto byte = at.hex(2)) {
    if (frame.size == most) return false;
    frame.data[frame.size++] = static_cast<std::uint8_t>(*byte);
    at.eat('.');
  }
  return true;
}

bool parse_raw_dlc(Cursor& at, can::Frame& frame) {
  if (!at.eat('_')) return true;
  const auto dlc = at.hex(1);
  if (!dlc || *dlc < 9 || frame.size != 8) return false;
  frame.raw_dlc = static_cast<std::uint8_t>(*dlc);
  return true;
}

bool parse_remote(Cursor& at, can::Frame& frame) {
  frame.remote = true;
  if (is_digit(at.peek())) {
    const auto size = at.hex(1);
    if (*size > 8) return false;
    frame.size = static_cast<std::uint8_t>(*size);
  }
  return parse_raw_dlc(at, frame);
}

bool parse_fd(Cursor& at, can::Frame& frame) {
  const auto flags = at.hex(1);
  if (!flags) return false;
  frame.fd = true;
  frame.bit_rate_switch = (*flags & 1U) != 0;
  frame.error_passive = (*flags & 2U) != 0;
  return parse_data(at, frame, can::kMaxData);
}

bool parse_identifier(std::string_view digits, can::Frame& frame) {
  const auto id = Cursor(digits).hex(digits.size());
  if (!id) return false;
  frame.extended = digits.size() == 8;
  if (!frame.extended) {
    frame.id = *id;
    return *id <= kStandardMask;
  }
  frame.error = (*id & kErrorFlag) != 0;
  if (frame.error) frame.extended = false;
  frame.id = *id & kExtendedMask;
  return (*id & ~(kErrorFlag | kExtendedMask)) == 0;
}

bool parse_frame(std::string_view text, can::Frame& frame) {
  const std::size_t hash = text.find('#');
  if (hash != 3 && hash != 8) return false;
  if (!parse_identifier(text.substr(0, hash), frame)) return false;
  Cursor at(text.substr(hash + 1));
  bool good = false;
  if (at.eat('#'))
    good = parse_fd(at, frame);
  else if (at.eat('R') || at.eat('r'))
    good = parse_remote(at, frame);
  else
    good = parse_data(at, frame, 8) && parse_raw_dlc(at, frame);
  return good && at.at_end();
}

bool is_xl(std::string_view text) {
  Cursor at(text);
  return at.hex(5) && at.eat('#') && at.hex(2) && at.eat(':') && at.hex(2) && at.eat(':') && at.hex(8) &&
         at.eat('#');
}

}  // namespace

CandumpLine parse_candump_line(std::string_view line, CanRecord& record) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  Cursor at(line);
  const auto time = parse_time(at);
  if (!time || !at.spaces()) return CandumpLine::kOther;
  const std::string_view interface = at.word();
  if (interface.empty() || interface.size() > kMaxInterface || !at.spaces()) return CandumpLine::kOther;
  const std::string_view text = at.word();
  if (at.spaces() && !at.eat('R')) at.eat('T');
  if (!at.at_end()) return CandumpLine::kOther;
  can::Frame frame;
  if (!parse_frame(text, frame)) return is_xl(text) ? CandumpLine::kXl : CandumpLine::kOther;
  record.time_ns = *time;
  record.interface = interface;
  record.frame = frame;
  return CandumpLine::kFrame;
}

std::string candump_line(const CanRecord& record) {
  const can::Frame& f = record.frame;
  char text[64];
  std::snprintf(text, sizeof text, "(%010lld.%06lld) ", static_cast<long long>(record.time_ns / 1000000000),
                static_cast<long long>(record.time_ns / 1000 % 1000000));
  std::string line = text + record.interface;
  const bool long_id = f.extended || f.error;
  std::snprintf(text, sizeof text, long_id ? " %08X#" : " %03X#", f.error ? f.id | kErrorFlag : f.id);
  line += text;
  if (f.remote) {
    line += 'R';
    if (f.size > 0) line += static_cast<char>('0' + std::min<int>(f.size, 8));
  } else if (f.fd) {
    std::snprintf(text, sizeof text, "#%X", 4U | (f.bit_rate_switch ? 1U : 0U) | (f.error_passive ? 2U : 0U));
    line += text;
  }
  for (int i = 0; !f.remote && i < std::min<int>(f.size, can::kMaxData); ++i) {
    std::snprintf(text, sizeof text, "%02X", f.data[i]);
    line += text;
  }
  if (f.raw_dlc > 8 && !f.fd && f.size == 8) {
    std::snprintf(text, sizeof text, "_%X", f.raw_dlc & 0xFU);
    line += text;
  }
  return line;
}

}  // namespace rigsound::log
