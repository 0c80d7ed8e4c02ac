// PEAK TRC, "PEAK CAN TRC File Format", versions 1.0 to 2.1.
#include <optional>

#include "log/can_lines.hpp"
#include "log/token_list.hpp"

namespace rigsound::log {
namespace {

constexpr std::uint32_t kMostBuses = 255;
constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// Where what stands in a line; empty: not in this version.
struct Columns {
  std::optional<std::size_t> time, type, bus, id, direction, code, length, data;
};

/// The columns of the versions whose header names none. The message number is column 0.
Columns columns_of(std::string_view version) {
  Columns c;
  c.time = 1;
  if (version == "1.0") {
    c.id = 2, c.code = 3, c.data = 4;
  } else if (version == "1.1") {
    c.direction = 2, c.id = 3, c.code = 4, c.data = 5;
  } else if (version == "1.2") {
    c.bus = 2, c.direction = 3, c.id = 4, c.code = 5, c.data = 6;
  } else if (version == "1.3") {
    c.bus = 2, c.direction = 3, c.id = 4, c.code = 6, c.data = 7;
  } else if (version == "2.0") {
    c.type = 2, c.id = 3, c.direction = 4, c.length = 5, c.data = 6;
  } else {
    c.type = 2, c.bus = 3, c.id = 4, c.direction = 5, c.code = 7, c.data = 8;
  }
  return c;
}

/// `N,O,T,B,I,d,R,L,D`
Columns columns_named(std::string_view letters) {
  Columns c;
  std::size_t at = 0;
  for (const char letter : letters) {
    if (letter == ',') continue;
    if (letter == 'O') c.time = at;
    if (letter == 'T') c.type = at;
    if (letter == 'B') c.bus = at;
    if (letter == 'I') c.id = at;
    if (letter == 'd') c.direction = at;
    if (letter == 'L') c.code = at;
    if (letter == 'l') c.length = at;
    if (letter == 'D') c.data = at;
    ++at;
  }
  return c;
}

class TrcFormat : public CanLineFormat {
 public:
  CanLine parse(std::string_view line, CanRecord& record) override {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.substr(0, 1) == ";") return read_header(line), CanLine::kOther;
    const TokenList tokens(line);
    const auto stamp = columns_.time ? decimal_ns(tokens[*columns_.time], kMillisecond_ns) : std::nullopt;
    can::Frame frame;
    if (!stamp || !columns_.id || !columns_.data || !parse_frame(tokens, frame)) return CanLine::kOther;
    const auto bus = columns_.bus ? number_of(tokens[*columns_.bus], 10, kMostBuses) : std::nullopt;
    record = {*stamp, interface_of_channel(bus.value_or(1)), frame};
    return CanLine::kFrame;
  }

  bool begins_a_frame(std::string_view line) const override {
    const TokenList tokens(line);
    return line.substr(0, 1) != ";" && tokens.size() > 1 && decimal_ns(tokens[1], kMillisecond_ns);
  }

 private:
  void read_header(std::string_view line) {
    constexpr std::string_view kVersion = ";$FILEVERSION=", kColumns = ";$COLUMNS=";
    if (line.substr(0, kVersion.size()) == kVersion) columns_ = columns_of(line.substr(kVersion.size()));
    if (line.substr(0, kColumns.size()) == kColumns) columns_ = columns_named(line.substr(kColumns.size()));
  }

  /// DT, RR and the kinds of FD frames (FD, FB: bit rate switch, FE: ESI, BI: both). In versions before 2 the
  /// direction column says what else a line is.
  bool parse_type(const TokenList& tokens, can::Frame& frame) const {
    if (columns_.direction) {
      const std::string_view direction = tokens[*columns_.direction];
      if (direction != "Rx" && direction != "Tx") return false;
    }
    if (!columns_.type) return true;
    const std::string_view type = tokens[*columns_.type];
    frame.remote = type == "RR";
    frame.bit_rate_switch = type == "FB" || type == "BI";
    frame.error_passive = type == "FE" || type == "BI";
    frame.fd = type == "FD" || frame.bit_rate_switch || frame.error_passive;
    return frame.fd || frame.remote || type == "DT";
  }

  bool parse_length(const TokenList& tokens, can::Frame& frame) const {
    const auto code = columns_.code ? number_of(tokens[*columns_.code], 10, 15) : std::nullopt;
    const auto length =
        columns_.length ? number_of(tokens[*columns_.length], 10, can::kMaxData) : std::nullopt;
    if (!code && !length) return false;
    const int bytes = length ? static_cast<int>(*length) : bytes_of_code(*code);
    frame.size = static_cast<std::uint8_t>(frame.fd ? bytes : std::min(bytes, 8));
    return true;
  }

  bool parse_frame(const TokenList& tokens, can::Frame& frame) const {
    const std::string_view id_text = tokens[*columns_.id];
    frame.extended = id_text.size() > 4;  // four digits, or eight
    const auto id = number_of(id_text, 16, frame.extended ? can::kMaxExtendedId : can::kMaxStandardId);
    if (!id || !parse_type(tokens, frame) || !parse_length(tokens, frame)) return false;
    frame.id = *id;
    frame.remote = frame.remote || tokens[*columns_.data] == "RTR";
    return frame.remote ? !frame.fd : take_bytes(tokens, *columns_.data, 16, frame);
  }

  Columns columns_ = columns_of("1.0");
};

}  // namespace

std::unique_ptr<CanLineFormat> trc_format() { return std::make_unique<TrcFormat>(); }

}  // namespace rigsound::log
