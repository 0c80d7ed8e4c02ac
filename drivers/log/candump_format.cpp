// Lines of candump: the log it writes with -l, and what it shows on the screen (lib.c of can-utils prints
// both).
#include <optional>

#include "log/can_lines.hpp"
#include "log/frame_text.hpp"
#include "log/line_cursor.hpp"

namespace rigsound::log {
namespace {

constexpr std::size_t kMaxInterface = 15;             // IFNAMSIZ without its zero
constexpr std::int64_t kWithoutStamp_ns = 1'000'000;  // between two lines that carry no stamp

/// Days from 1970-01-01 (H. Hinnant, chrono-compatible low-level date algorithms).
std::int64_t days_from_civil(std::int64_t year, std::int64_t month, std::int64_t day) {
  year -= month <= 2 ? 1 : 0;
  const std::int64_t era = year / 400, of_era = year % 400;
  const std::int64_t of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

std::optional<std::int64_t> number_before(LineCursor& at, char sign, std::int64_t max) {
  const auto value = whole_number(at.digits(), max);
  return value && at.eat(sign) ? value : std::nullopt;
}

/// `2023-05-10 12:00:00` as seconds; what zone it is in does not count.
std::optional<std::int64_t> date_and_time(LineCursor& at, std::int64_t year) {
  const auto month = number_before(at, '-', 12), day = number_before(at, ' ', 31),
             hour = number_before(at, ':', 23), minute = number_before(at, ':', 59),
             second = whole_number(at.digits(), 60);
  if (!month || *month < 1 || !day || !hour || !minute || !second || year < 1970 || year > 2254)
    return std::nullopt;
  return ((days_from_civil(year, *month, *day) * 24 + *hour) * 60 + *minute) * 60 + *second;
}

/// `(seconds.decimals)`, or `(date time.decimals)`.
std::optional<std::int64_t> parse_stamp(LineCursor& at) {
  if (!at.eat('(')) return std::nullopt;
  auto seconds = whole_number(at.digits(), kMaxSeconds);
  if (seconds && at.eat('-')) seconds = date_and_time(at, *seconds);
  if (!seconds || !at.eat('.')) return std::nullopt;
  const auto fraction = nine_decimals(at.digits());
  if (!fraction || !at.eat(')')) return std::nullopt;
  return *seconds * kNano + *fraction;
}

/// `RX - -` or `TX B E` of candump -x, when it is there.
void skip_direction(LineCursor& at) {
  LineCursor ahead = at;
  const std::string_view direction = ahead.token();
  if (direction != "RX" && direction != "TX") return;
  for (const char flag : {'B', 'E'})
    if (!ahead.eat('-') && !ahead.eat(flag))
      return;
    else
      ahead.spaces();
  at = ahead;
}

/// `[8]` of a classic frame, `[08]` of an FD frame, `{F}` a classic length code.
bool parse_length(LineCursor& at, can::Frame& frame) {
  const bool raw = at.peek() == '{';
  if (!at.eat('[') && !at.eat('{')) return false;
  const std::string_view digits = at.hex_digits();
  if (!at.eat(raw ? '}' : ']')) return false;
  frame.fd = digits.size() == 2;
  const auto decimal = whole_number(digits, can::kMaxData);
  if (raw) {
    const int code = digits.size() == 1 ? hex_digit(digits.front()) : -1;
    frame.size = static_cast<std::uint8_t>(code > 8 ? 8 : code);
    frame.raw_dlc = static_cast<std::uint8_t>(code > 8 ? code : 0);
    return code >= 0;
  }
  if (!decimal || digits.size() > 2 || (!frame.fd && *decimal > 8)) return false;
  frame.size = static_cast<std::uint8_t>(*decimal);
  return true;
}

/// One byte, `F0` or `11110000`.
std::optional<std::uint8_t> parse_byte(LineCursor& at) {
  const std::string_view digits = at.hex_digits();
  unsigned value = 0;
  if (digits.size() != 2 && digits.size() != 8) return std::nullopt;
  for (const char c : digits) {
    const auto digit = static_cast<unsigned>(hex_digit(c));
    if (digits.size() == 8 && digit > 1) return std::nullopt;
    value = digits.size() == 8 ? value << 1 | digit : value << 4 | digit;
  }
  return static_cast<std::uint8_t>(value);
}

/// As many bytes as the length says; with -S the last one comes first, and they are parted by "`". What -a
/// shows of them as text comes after.
bool parse_shown_bytes(LineCursor& at, can::Frame& frame) {
  bool swapped = false;
  for (int i = 0; i < frame.size; ++i) {
    at.spaces();
    if (i > 0 && at.eat('`')) swapped = true;
    const auto byte = parse_byte(at);
    if (!byte) return false;
    frame.data[static_cast<std::size_t>(i)] = *byte;
  }
  if (swapped) std::reverse(frame.data.begin(), frame.data.begin() + frame.size);
  return true;
}

/// `0CF00400   [8]  F0 7D ...`; CAN FD has no remote requests.
bool parse_shown_frame(LineCursor& at, can::Frame& frame) {
  if (!parse_identifier(at.token(), frame) || !parse_length(at, frame)) return false;
  at.spaces();
  constexpr std::string_view kRemote = "remote request";
  frame.remote = at.rest().substr(0, kRemote.size()) == kRemote;
  return frame.remote ? !frame.fd : parse_shown_bytes(at, frame);
}

std::string without_colours(std::string_view line) {
  std::string plain;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\x1b') {
      plain += line[i];
      continue;
    }
    while (i < line.size() && line[i] != 'm') ++i;
  }
  return plain;
}

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  while (!line.empty() && (line.front() == '\t' || line.front() == ' ')) line.remove_prefix(1);
  return line;
}

class CandumpFormat : public CanLineFormat {
 public:
  explicit CandumpFormat(CandumpStamps stamps) : stamps_(stamps) {}

  CanLine parse(std::string_view line, CanRecord& record) override {
    if (line.find('\x1b') != std::string_view::npos) {
      const std::string plain = without_colours(line);
      return parse_plain(plain, record);
    }
    return parse_plain(line, record);
  }

  bool begins_a_frame(std::string_view line) const override {
    line = trimmed(line);
    return !line.empty() && (line.front() == '(' || line.find(" [") != std::string_view::npos);
  }

  std::string remark() const override {
    if (without_stamp_) return "carries no time stamps: its frames are taken as 1 ms apart";
    return stamps_ == CandumpStamps::kSinceLastFrame ? "its stamps count from frame to frame" : "";
  }

 private:
  CanLine parse_plain(std::string_view line, CanRecord& record) {
    LineCursor at(trimmed(line));
    const bool stamped = at.peek() == '(';
    const auto stamp = stamped ? parse_stamp(at) : std::nullopt;
    if (stamped && (!stamp || !at.spaces())) return CanLine::kOther;
    const std::string_view interface = at.word();
    if (interface.empty() || interface.size() > kMaxInterface || !at.spaces()) return CanLine::kOther;
    const LineCursor after_interface = at;
    const std::string_view text = at.word();
    can::Frame frame;
    if (text.find('#') == std::string_view::npos) {
      at = after_interface;
      skip_direction(at);
      if (!parse_shown_frame(at, frame)) return CanLine::kOther;
    } else {
      if (at.spaces() && !at.eat('R')) at.eat('T');
      if (!stamped || !at.at_end()) return CanLine::kOther;
      if (!parse_frame_text(text, frame)) return is_xl_text(text) ? CanLine::kXl : CanLine::kOther;
    }
    record.time_ns = time_of(stamp);
    record.interface = interface;
    record.frame = frame;
    return CanLine::kFrame;
  }

  std::int64_t time_of(std::optional<std::int64_t> stamp) {
    if (!stamp) without_stamp_ = true;
    if (stamp && stamps_ == CandumpStamps::kAbsolute) return *stamp;
    sum_ns_ = std::min(sum_ns_ + stamp.value_or(kWithoutStamp_ns), kMaxSeconds * kNano);
    return sum_ns_;
  }

  CandumpStamps stamps_;
  std::int64_t sum_ns_ = 0;
  bool without_stamp_ = false;
};

}  // namespace

std::unique_ptr<CanLineFormat> candump_format(CandumpStamps stamps) {
  return std::make_unique<CandumpFormat>(stamps);
}

}  // namespace rigsound::log
