// Eats a line of text from the left.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rigsound::log {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::array<std::int8_t, 256> make_hex_digits() {
  std::array<std::int8_t, 256> digits{};
  for (std::int8_t& digit : digits) digit = -1;
  for (int i = 0; i < 10; ++i) digits['0' + i] = static_cast<std::int8_t>(i);
  for (int i = 10; i < 16; ++i) digits['a' + i - 10] = digits['A' + i - 10] = static_cast<std::int8_t>(i);
  return digits;
}

inline constexpr std::array<std::int8_t, 256> kHexDigits = make_hex_digits();

/// -1 for what is no hexadecimal digit.
constexpr int hex_digit(char c) { return kHexDigits[static_cast<unsigned char>(c)]; }

/// Every function says whether it found what it wanted and eats only then. Never reads past the end.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : text_(text) {}

  bool at_end() const { return text_.empty(); }
  char peek() const { return text_.empty() ? '\0' : text_.front(); }
  std::string_view rest() const { return text_; }
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
    return run([](char c) { return is_digit(c); });
  }
  std::string_view hex_digits() {
    return run([](char c) { return hex_digit(c) >= 0; });
  }
  std::string_view word() {
    return run([](char c) { return c != ' ' && c != '\t'; });
  }
  /// A word, and the blanks after it.
  std::string_view token() {
    const std::string_view found = word();
    spaces();
    return found;
  }
  /// Exactly `count` digits, at most 8.
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
  template <class Wanted>
  std::string_view run(Wanted wanted) {
    const auto end = std::find_if_not(text_.begin(), text_.end(), wanted);
    return take(static_cast<std::size_t>(end - text_.begin()));
  }
  std::string_view take(std::size_t n) {
    const std::string_view taken = text_.substr(0, n);
    text_.remove_prefix(n);
    return taken;
  }
  std::string_view text_;
};

/// Decimal digits up to `max`; nothing for more, and for no digit or another character.
inline std::optional<std::int64_t> whole_number(std::string_view digits, std::int64_t max) {
  if (digits.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    if (!is_digit(c)) return std::nullopt;
    value = value * 10 + (c - '0');
    if (value > max) return std::nullopt;
  }
  return value;
}

constexpr std::int64_t kNano = 1'000'000'000;
constexpr std::int64_t kMaxSeconds = 9'000'000'000;  ///< the year 2255; nanoseconds fit into 63 bits

/// Nine decimals of a fraction written with one to nine digits.
inline std::optional<std::int64_t> nine_decimals(std::string_view digits) {
  if (digits.size() > 9) return std::nullopt;
  auto value = whole_number(digits, kNano);
  for (std::size_t i = digits.size(); value && i < 9; ++i) *value *= 10;
  return value;
}

/// `12.345`, or `12`, in units of `unit_ns` nanoseconds (at most 1e9) as nanoseconds.
inline std::optional<std::int64_t> decimal_ns(std::string_view text, std::int64_t unit_ns) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const auto whole = whole_number(text.substr(0, point), kMaxSeconds);
  if (!whole) return std::nullopt;
  if (point == text.size()) return *whole * unit_ns;
  const auto fraction = nine_decimals(text.substr(point + 1));
  if (!fraction) return std::nullopt;
  return *whole * unit_ns + *fraction / (kNano / unit_ns);
}

}  // namespace rigsound::log
